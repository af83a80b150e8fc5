/** A position, an offset or a direction: x, y and z. */
export type Vector = [number, number, number];

/** The ids of two vertices: the ends of an edge, or those that a half-edge leaves and points to. */
export type Pair = [number, number];

/** A kind of element. */
export type Kind = "vertex" | "edge" | "halfedge" | "face";

/** Counts of elements; local edits also list their ids. */
export interface Elements {
  vertices: number;
  edges: number;
  faces: number;
  ids?: { vertices: number[]; edges: number[]; faces: number[] };
}

/** A note on a file that was read. */
export interface ReportNote {
  severity: "info" | "warning";
  text: string;
}

/** The outcome of a command. */
export interface Outcome {
  op: string;
  created: Elements;
  removed: Elements;
  /** One sentence that says what was done. */
  message: string;
  warnings: string[];
  /** The import report, after opening files. */
  report?: ReportNote[];
}

/** The state of the editor; counts cover all objects together. */
export interface State {
  document: {
    name: string;
    objects: {
      name: string;
      visible: boolean;
      faces: number;
      bezier?: unknown;
      repairable?: boolean;
      /** The number of hidden faces, where there are any. */
      hidden?: number;
      /** The named selections, where there are any. */
      selections?: { name: string; kind: Kind; count: number }[];
    }[];
    active: number;
    vertices: number;
    edges: number;
    halfedges: number;
    faces: number;
    boundary_loops: number;
    components: number;
    euler: number;
    dirty: boolean;
    /** Add it to positions to get the coordinates of the files; left out if it is zero. */
    offset?: Vector;
  };
  selection: { kind: Kind; ids: number[] };
  history: { undo: string[]; redo: string[]; bytes: number };
  jobs: { op: string; progress: number | null }[];
  messages: { kind: string; text: string }[];
  view: { renderer: string; frame_ms: { median: number; worst: number }; [name: string]: unknown };
}

export interface Vertex {
  id: number;
  position: Vector;
  /** A half-edge that leaves it; null for an isolated vertex. */
  halfedge: number | null;
  valence: number;
  boundary: boolean;
}

export interface Edge {
  id: number;
  halfedge: number;
  vertices: Pair;
  /** The faces on its two sides; null on the boundary. */
  faces: [number | null, number | null];
  length: number | null;
  crease: number | null;
  boundary: boolean;
}

export interface Halfedge {
  id: number;
  next: number;
  prev: number;
  twin: number;
  /** The vertex it points to. */
  vertex: number;
  edge: number;
  /** Null on the boundary. */
  face: number | null;
  boundary: boolean;
}

export interface Face {
  id: number;
  halfedge: number;
  corners: number[];
  /** `#rrggbb`. */
  color: string;
  area: number | null;
  boundary: boolean;
}

/** A file by its name. */
export interface NamedFile<Content> {
  name: string;
  content: Content;
}

/** The bytes of a file, or its text. */
export type Content = string | ArrayBuffer | ArrayBufferView;

/** What can be subscribed to, and what callbacks are given. */
export interface Events {
  /** The document changed: its name, whether it has unsaved changes, and the last edit of its history. */
  change: { name: string; dirty: boolean; last: string | null };
  /** Something else is selected: its kind, and how many. */
  selection: { kind: Kind; count: number };
  /** A job began, went on or ended: those that run. */
  job: { jobs: { op: string; progress: number }[] };
}

/** `window.meshwright`. Promises reject, and the other methods throw, an `Error` that says why. */
export interface Meshwright {
  /** Resolves when the editor is ready. */
  ready: Promise<{ version: string; renderer: "webgpu" | "webgl2" }>;
  /** Replace the document by a file. */
  open(name: string, content: Content): Promise<Outcome>;
  /** Open files that belong together, such as an OBJ file and its materials. */
  openFiles(files: NamedFile<Content>[]): Promise<Outcome>;
  /** Run a command. */
  run(command: Command): Promise<Outcome>;
  /** Write the document; resolves with the model's own file. */
  export(format: string): Promise<Uint8Array>;
  /** Write the document; resolves with the model's file and its companion files. */
  exportFiles(format: string): Promise<NamedFile<Uint8Array>[]>;
  state(): State;
  element(kind: "vertex", id: number): Vertex;
  element(kind: "edge", id: number): Edge;
  element(kind: "halfedge", id: number): Halfedge;
  element(kind: "face", id: number): Face;
  /** Replace the selection by elements of the active object. */
  select(kind: Kind, ids: number[]): void;
  /** Undo the last step; returns its label, or null if there is none. */
  undo(): string | null;
  /** Redo the last undone step; returns its label, or null if there is none. */
  redo(): string | null;
  /** Cancel all jobs; returns their number. */
  cancel(): number;
  /** Call back at each event of a name, after the frame in which it happened; returns a function that ends it. */
  on<Name extends keyof Events>(name: Name, callback: (event: Events[Name]) => void): () => void;
  /** A position on the page, in CSS pixels; null if it is behind the camera. */
  project(point: Vector): [number, number] | null;
  /** The widgets on the screen, from the accessibility tree. */
  ui(): {
    role: string;
    name: string;
    value: number | string | null;
    description?: string;
    /** x, y, width and height in CSS pixels of the page. */
    rect: [number, number, number, number];
    disabled: boolean;
    selected: boolean | null;
  }[];
}

declare global {
  interface Window {
    meshwright: Meshwright;
  }
}
