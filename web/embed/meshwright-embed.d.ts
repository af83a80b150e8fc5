// The types of meshwright-embed.js. `../meshwright.d.ts`, which is generated, has those of commands and results.

import type {
  Command, Content, Edge, Events, Face, Halfedge, Kind, Meshwright, NamedFile, Vector, Vertex,
} from "../meshwright";

export interface Options {
  /** The editor's address; by default the site that this module comes from. */
  page?: string;
  /** The parts to show around the viewport. */
  panels?: ("menu" | "tools" | "lists" | "inspector" | "status")[];
  /** The address of a file to open. */
  model?: string;
  /** A link made by File > Share, to open its document. */
  link?: string;
  /** What screen readers call the frame. */
  title?: string;
}

/** What a method of the embedded editor gives, always as a promise. */
type Later<Method> = Method extends (...args: infer Args) => infer Result
  ? (...args: Args) => Promise<Awaited<Result>>
  : never;

type Called =
  | "open" | "openFiles" | "run" | "export" | "exportFiles" | "state" | "select" | "undo" | "redo" | "cancel"
  | "project";

interface ElementOf {
  vertex: Vertex;
  edge: Edge;
  halfedge: Halfedge;
  face: Face;
}

export type Embedded = { [Name in Called]: Later<Meshwright[Name]> } & {
  element<Name extends Kind>(kind: Name, id: number): Promise<ElementOf[Name]>;
  ready: Meshwright["ready"];
  frame: HTMLIFrameElement;
  on<Name extends keyof Events>(name: Name, callback: (event: Events[Name]) => void): () => void;
  remove(): void;
};

/** Puts the editor into an element, whose size it takes. */
export function embed(container: HTMLElement, options?: Options): Embedded;

export type { Command, Content, NamedFile, Vector };
