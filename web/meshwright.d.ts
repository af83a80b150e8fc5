// The commands of Meshwright and the API of `window.meshwright`.
// Made from the operations' descriptions: `MESHWRIGHT_UPDATE=1 cargo test -p editor --test script` rewrites it.

/** Move a vertex to a position. */
export interface SetVertexPosition {
  op: "set-vertex-position";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertex to move: a vertex by id; default: the selected vertex. */
  vertex?: number;
  /** The new position, in mesh units: three numbers: `[x, y, z]`; required. */
  position: Vector;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Move, rotate and scale elements. */
export interface Transform {
  op: "transform";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Vertices to move: a list of vertices, each by id; default: the vertices of the selection. */
  vertices?: number[];
  /** Edges whose ends to move: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: none. */
  edges?: (number | Pair)[];
  /** Faces whose corners to move: a list of faces, each by id; default: none. */
  faces?: number[];
  /** How far to move, in mesh units: three numbers: `[x, y, z]`; default: [0.0,0.0,0.0]. */
  translate?: Vector;
  /** How to rotate about the pivot: an axis and degrees: `{"axis": [0, 0, 1], "degrees": 90}`; default: no rotation. */
  rotate?: { axis: Vector; degrees: number };
  /** The factor by which to scale about the pivot: a factor, or three: `[x, y, z]`; default: 1.0. */
  scale?: number | Vector;
  /** How the axes of the scale are turned: an axis and degrees: `{"axis": [0, 0, 1], "degrees": 90}`; default: the axes of the mesh. */
  orientation?: { axis: Vector; degrees: number };
  /** Rotate and scale each connected part about its own middle, not about the pivot: `true` or `false`; default: false. */
  individual?: boolean;
  /** The point that stays in place: three numbers: `[x, y, z]`; default: the centre of the vertices. */
  pivot?: Vector;
  /** Soft selection: how far along the surface other vertices move too: a number in mesh units, 0 or more; default: none. */
  falloff?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Paint faces with a colour. */
export interface SetFaceColor {
  op: "set-face-color";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to paint: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** The colour as #rrggbb: a colour: `"#rrggbb"`; required. */
  color: string;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Add a vertex to an edge and cut the faces beside it. */
export interface SplitEdge {
  op: "split-edge";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edge to split: an edge by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edge?: number | Pair;
  /** The position along the edge, between its ends: a number above 0 and below 1; default: 0.5. */
  t?: number;
  /** Which of the faces beside the edge are cut: one of `"triangles"`, `"none"`, `"all"`; default: triangles. */
  connect?: "triangles" | "none" | "all";
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Turn an edge one step counter-clockwise within its two faces. */
export interface FlipEdge {
  op: "flip-edge";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edge to flip: an edge by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edge?: number | Pair;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Merge the two ends of an edge into one vertex. */
export interface CollapseEdge {
  op: "collapse-edge";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edge to collapse: an edge by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edge?: number | Pair;
  /** The position of the vertex along the edge: a number from 0 to 1; default: 0.5. */
  t?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Merge all corners of a face into one vertex at its centre. */
export interface CollapseFace {
  op: "collapse-face";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The face to collapse: a face by id; default: the selected faces. */
  face?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Split a vertex into two, joined by an edge. */
export interface SplitVertex {
  op: "split-vertex";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertex to split: a vertex by id; default: where the two edges meet. */
  vertex?: number;
  /** Two of its edges: a list of two edges, each by id or by `[a, b]`, the vertices at its ends; default: the two selected edges. */
  edges?: [number | Pair, number | Pair];
  /** The positions of the two vertices: two positions: `[[x, y, z], [x, y, z]]`; default: a little apart. */
  positions?: [Vector, Vector];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Remove vertices and merge the faces around each into one polygon. */
export interface DissolveVertex {
  op: "dissolve-vertex";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertex to dissolve: a vertex by id; default: those of `vertices`. */
  vertex?: number;
  /** The vertices to dissolve, one after the other: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Remove edges and merge the faces beside them into one polygon. */
export interface DissolveEdge {
  op: "dissolve-edge";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edge to dissolve: an edge by id or by `[a, b]`, the vertices at its ends; default: those of `edges`. */
  edge?: number | Pair;
  /** The edges to dissolve together: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** Whether vertices that are left with two edges stay: `true` or `false`; default: false. */
  keep_vertices?: boolean;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Delete faces, and vertices that are left with no face. */
export interface DeleteFaces {
  op: "delete-faces";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to delete: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Delete vertices and the faces around them. */
export interface DeleteVertices {
  op: "delete-vertices";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertices to delete: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Cut polygons into triangles between their own corners. */
export interface TriangulateFaces {
  op: "triangulate-faces";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to cut: a list of faces, each by id; default: the selected faces, or all. */
  faces?: number[];
  /** A fan from the first corner if that is correct, else ears; or always one of the two: one of `"auto"`, `"fan"`, `"ear"`; default: auto. */
  method?: "auto" | "fan" | "ear";
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Add a vertex at the centre of each face and join it to every corner. */
export interface PokeFaces {
  op: "poke-faces";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to poke: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Cut a face from one of its corners to another. */
export interface ConnectVertices {
  op: "connect-vertices";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Two corners of one face: a list of two vertices, each by id; default: the two selected vertices. */
  vertices?: [number, number];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Move faces outward and build walls behind them. */
export interface ExtrudeFaces {
  op: "extrude-faces";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to extrude: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** How far outward, in mesh units: a number in mesh units; required. */
  distance: number;
  /** Whether faces that share an edge stay together: one of `"region"`, `"individual"`; default: region. */
  mode?: "region" | "individual";
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Add a quad beside each boundary edge. */
export interface ExtrudeEdges {
  op: "extrude-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The boundary edges to extrude: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** From the edges to the far sides, in mesh units: three numbers: `[x, y, z]`; required. */
  offset: Vector;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Add a ring of quads inside the outline of faces. */
export interface InsetFaces {
  op: "inset-faces";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces to inset: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** The width of the ring, in mesh units: a number in mesh units, 0 or more; required. */
  amount: number;
  /** Whether faces that share an edge stay together: one of `"region"`, `"individual"`; default: region. */
  mode?: "region" | "individual";
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Replace each edge by a strip of faces. */
export interface BevelEdges {
  op: "bevel-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edges to bevel: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** The width on each side of the edge, in mesh units: a number in mesh units, 0 or more; required. */
  width: number;
  /** The number of faces across the strip: a whole number from 1 to 256; default: 1. */
  segments?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Cut off each vertex with a face. */
export interface BevelVertices {
  op: "bevel-vertices";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertices to bevel: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
  /** How far along each edge, in mesh units: a number in mesh units, 0 or more; required. */
  width: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Cut the ring of quads that crosses an edge. */
export interface LoopCut {
  op: "loop-cut";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** An edge that the ring crosses: an edge by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edge?: number | Pair;
  /** How many cuts: a whole number from 1 to 1000; default: 1. */
  cuts?: number;
  /** The position of the middle of the cuts along the edge: a number above 0 and below 1; default: 0.5. */
  t?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Move lines of edges over the surface, along the edges beside them. */
export interface SlideEdges {
  op: "slide-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edges, in lines that don't branch; left is that of the first edge's direction: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** How far: 1 is to the neighbours on the left, -1 to those on the right: a number from -1 to 1; required. */
  amount: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Move each vertex along the one of its edges that points most in a direction. */
export interface SlideVertices {
  op: "slide-vertices";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertices to slide: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
  /** Each vertex moves along the edge that points most in this direction: three numbers: `[x, y, z]`; default: [1.0,0.0,0.0]. */
  direction?: Vector;
  /** How far: 1 is to the edges' other ends; below 0 is the other way: a number from -1 to 1; required. */
  amount: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Close a boundary loop with one polygon. */
export interface FillHole {
  op: "fill-hole";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** A half-edge of the boundary loop: a half-edge by id or by `[from, to]`, its vertices; default: the selected half-edges. */
  halfedge?: number | Pair;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Join two boundary loops, or two faces or regions that it replaces, with a band of faces; of more than two, those that are closest to each other. */
export interface Bridge {
  op: "bridge";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Boundary half-edges, one or more of each loop: a list of half-edges, each by id or by `[from, to]`, its vertices; default: the selected half-edges. */
  halfedges?: (number | Pair)[];
  /** Faces to replace, in two regions or more: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** How many loops of edges to add between the two: a whole number from 0 to 1000; default: 0. */
  cuts?: number;
  /** By how many vertices to turn one loop against the other: a whole number from -1000 to 1000; default: 0. */
  twist?: number;
  /** How far the band goes on in the directions of the surfaces: 0 is straight, 1 leaves both smoothly, and more makes it rounder; it takes cuts: a number from 0 to 4; default: 0.0. */
  smoothness?: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Merge several vertices into one. */
export interface MergeVertices {
  op: "merge-vertices";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The vertices to merge: a list of vertices, each by id; default: the vertices of the selection. */
  vertices?: number[];
  /** The position of the merged vertex: three numbers: `[x, y, z]`; default: the centre of the vertices. */
  position?: Vector;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Join two boundary edges into one. */
export interface WeldEdges {
  op: "weld-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Two boundary edges: a list of two edges, each by id or by `[a, b]`, the vertices at its ends; default: the two selected edges. */
  edges?: [number | Pair, number | Pair];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Make edges boundary: the faces on either side come apart. */
export interface RipEdges {
  op: "rip-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The edges to rip: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Turn whole connected pieces inside out. */
export interface FlipOrientation {
  op: "flip-orientation";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The faces of whole connected pieces: a list of faces, each by id; default: the selected faces, or all. */
  faces?: number[];
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Set how sharp edges and vertices stay under subdivision. */
export interface SetCrease {
  op: "set-crease";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Edges to make sharp: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** Vertices to make sharp: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
  /** 0 is smooth, 10 or more infinitely sharp: a number, 0 or more; required. */
  sharpness: number;
  /** Mirror the edit across the plane through the origin that this axis is normal to: one of `"none"`, `"x"`, `"y"`, `"z"`; default: none. */
  symmetry?: "none" | "x" | "y" | "z";
}

/** Subdivide any polygons into quads that approach a smooth surface. */
export interface SubdivideCatmullClark {
  op: "subdivide-catmull-clark";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of levels: a whole number from 1 to 12; default: 1. */
  levels?: number;
  /** Whether corners of the boundary stay: one of `"edge-only"`, `"edge-and-corner"`; default: edge-only. */
  boundary?: "edge-only" | "edge-and-corner";
  /** Where old vertices go: as in OpenSubdiv, or as in MayaLite: one of `"standard"`, `"smoothed-midpoints"`; default: standard. */
  vertex_rule?: "standard" | "smoothed-midpoints";
}

/** Subdivide triangles into triangles that approach a smooth surface. */
export interface SubdivideLoop {
  op: "subdivide-loop";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of levels: a whole number from 1 to 12; default: 1. */
  levels?: number;
  /** Whether corners of the boundary stay: one of `"edge-only"`, `"edge-and-corner"`; default: edge-only. */
  boundary?: "edge-only" | "edge-and-corner";
  /** How much a vertex's neighbours count: as in OpenSubdiv, or as in the CS184 course: one of `"loop"`, `"warren"`; default: loop. */
  weights?: "loop" | "warren";
}

/** Cut polygons into quads without smoothing. */
export interface SubdivideLinear {
  op: "subdivide-linear";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of levels: a whole number from 1 to 12; default: 1. */
  levels?: number;
}

/** Keep the shape with fewer triangles; polygons are triangulated first. */
export interface Simplify {
  op: "simplify";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The share of the triangles to keep: a number above 0 and at most 1; exactly one of these is required. */
  ratio?: number;
  /** The number of triangles to keep: a whole number of triangles, 1 or more; exactly one of these is required. */
  faces?: number;
  /** The largest distance from the original surface, in mesh units: a number in mesh units, 0 or more; exactly one of these is required. */
  max_error?: number;
  /** Keep the shape of the boundary: `true` or `false`; default: true. */
  preserve_boundary?: boolean;
  /** Keep the seams of texture coordinates and normals: `true` or `false`; default: true. */
  preserve_seams?: boolean;
}

/** Make triangles with edges of one length; polygons are triangulated first. */
export interface Remesh {
  op: "remesh";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The length of edges, in mesh units: a number in mesh units above 0; default: about the mean length. */
  edge_length?: number;
  /** The number of iterations: a whole number from 1 to 1000; default: 5. */
  iterations?: number;
  /** Keep edges that are sharper than this many degrees: a number of degrees above 0 and at most 180; default: 45.0. */
  feature_angle?: number;
  /** Project vertices back onto the surface: `true` or `false`; default: true. */
  project?: boolean;
}

/** Move every vertex towards the centre of its neighbours. */
export interface Smooth {
  op: "smooth";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of iterations: a whole number from 1 to 10000; default: 1. */
  iterations?: number;
  /** The fraction of the way to move in each iteration: a number from 0 to 1; default: 0.5. */
  strength?: number;
  /** Move vertices towards their neighbours only, or also back, which nearly keeps the volume: one of `"laplacian"`, `"taubin"`; default: laplacian. */
  method?: "laplacian" | "taubin";
}

/** Merge vertices that are close to each other. */
export interface MergeByDistance {
  op: "merge-by-distance";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The largest distance between merged vertices, in mesh units; 0 for those at the same position: a number in mesh units, 0 or more; required. */
  distance: number;
}

/** Select elements by id. */
export interface SelectElements {
  op: "select-elements";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Vertices to select: a list of vertices, each by id; exactly one of these is required. */
  vertices?: number[];
  /** Edges to select: a list of edges, each by id or by `[a, b]`, the vertices at its ends; exactly one of these is required. */
  edges?: (number | Pair)[];
  /** Half-edges to select: a list of half-edges, each by id or by `[from, to]`, its vertices; exactly one of these is required. */
  halfedges?: (number | Pair)[];
  /** Faces to select: a list of faces, each by id; exactly one of these is required. */
  faces?: number[];
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select every element of a kind. */
export interface SelectAll {
  op: "select-all";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The kind of elements to select: one of `"vertex"`, `"edge"`, `"halfedge"`, `"face"`; default: the kind of the selection. */
  kind?: "vertex" | "edge" | "halfedge" | "face";
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Change the selection to its neighbours, pieces, loops or rings, or to another kind of element. */
export interface SelectRelated {
  op: "select-related";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** What to select: one of `"grow"`, `"shrink"`, `"linked"`, `"loops"`, `"rings"`, `"path"`, `"outline"`, `"vertices"`, `"edges"`, `"halfedges"`, `"faces"`, `"touching-edges"`, `"touching-halfedges"`, `"touching-faces"`; default: grow. */
  by?: "grow" | "shrink" | "linked" | "loops" | "rings" | "path" | "outline" | "vertices" | "edges" | "halfedges" | "faces" | "touching-edges" | "touching-halfedges" | "touching-faces";
}

/** Select boundary edges and half-edges, the vertices on them, or the faces beside them. */
export interface SelectBoundary {
  op: "select-boundary";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The kind of elements to select: one of `"vertex"`, `"edge"`, `"halfedge"`, `"face"`; default: the kind of the selection. */
  kind?: "vertex" | "edge" | "halfedge" | "face";
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select edges whose two faces meet at more than an angle. */
export interface SelectSharpEdges {
  op: "select-sharp-edges";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The angle: 0 is flat, 90 an edge of a cube: a number of degrees from 0 to 180; default: 30.0. */
  angle?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select faces by the number of their corners. */
export interface SelectByCorners {
  op: "select-by-corners";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of corners: a whole number, 3 or more; default: 4. */
  corners?: number;
  /** How the face's number compares with it: one of `"equal"`, `"different"`, `"less"`, `"more"`; default: equal. */
  compare?: "equal" | "different" | "less" | "more";
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select vertices by the number of their edges. */
export interface SelectByValence {
  op: "select-by-valence";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The number of edges: a whole number, 0 or more; default: 4. */
  valence?: number;
  /** How the vertex's number compares with it: one of `"equal"`, `"different"`, `"less"`, `"more"`; default: equal. */
  compare?: "equal" | "different" | "less" | "more";
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select faces that are smaller or larger than an area. */
export interface SelectByArea {
  op: "select-by-area";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** How the area compares: one of `"less"`, `"more"`; default: less. */
  compare?: "less" | "more";
  /** With what: a number in square mesh units, 0 or more; required. */
  area: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select edges that are smaller or larger than a length. */
export interface SelectByLength {
  op: "select-by-length";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** How the length compares: one of `"less"`, `"more"`; default: less. */
  compare?: "less" | "more";
  /** With what: a number in mesh units, 0 or more; required. */
  length: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select polygons with a triangle that is turned by more than an angle against the mean plane. */
export interface SelectNonPlanar {
  op: "select-non-planar";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The angle that still counts as flat: a number of degrees from 0 to 180; default: 1.0. */
  angle?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select faces without area, or edges without length. */
export interface SelectDegenerate {
  op: "select-degenerate";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The kind of elements to select: one of `"vertex"`, `"edge"`, `"halfedge"`, `"face"`; default: the kind of the selection. */
  kind?: "vertex" | "edge" | "halfedge" | "face";
  /** The area or length that still counts as none: a number in mesh units, 0 or more; default: 0.0. */
  at_most?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select vertices in no face. */
export interface SelectIsolated {
  op: "select-isolated";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select what belongs to any connected component but the one with the most faces. */
export interface SelectSmallerComponents {
  op: "select-smaller-components";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The kind of elements to select: one of `"vertex"`, `"edge"`, `"halfedge"`, `"face"`; default: the kind of the selection. */
  kind?: "vertex" | "edge" | "halfedge" | "face";
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select faces that face the same way as the one selected last, or a direction. */
export interface SelectFacing {
  op: "select-facing";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The direction: three numbers: `[x, y, z]`; default: the normal of the face selected last. */
  direction?: Vector;
  /** The largest angle between it and a face's normal: a number of degrees from 0 to 180; default: 30.0. */
  angle?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select elements that share a property with the one selected last. */
export interface SelectSimilar {
  op: "select-similar";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The property: one of `"count"`, `"size"`, `"normal"`, `"color"`; default: count. */
  by?: "count" | "size" | "normal" | "color";
  /** How much it may differ, as a fraction: a number from 0 to 1; default: 0.009999999776482582. */
  tolerance?: number;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Select the elements of a named selection. */
export interface SelectNamed {
  op: "select-named";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The name: text; required. */
  name: string;
  /** How what is found changes the selection: one of `"replace"`, `"extend"`, `"toggle"`, `"remove"`, `"intersect"`; default: replace. */
  mode?: "replace" | "extend" | "toggle" | "remove" | "intersect";
}

/** Save the selection under a name, and replace any of that name. */
export interface NameSelection {
  op: "name-selection";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The name: text; required. */
  name: string;
}

/** Rename a named selection. */
export interface RenameNamedSelection {
  op: "rename-named-selection";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The name: text; required. */
  name: string;
  /** The new name: text; required. */
  to: string;
}

/** Delete a named selection; its elements stay. */
export interface DeleteNamedSelection {
  op: "delete-named-selection";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The name: text; required. */
  name: string;
}

/** Hide faces, or the faces of edges and vertices, in the viewport. */
export interface Hide {
  op: "hide";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Faces to hide: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** Edges: the faces beside them: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** Vertices: the faces around them: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
}

/** Show hidden faces again. */
export interface Reveal {
  op: "reveal";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
}

/** Hide everything else. Repeat to show everything. */
export interface Isolate {
  op: "isolate";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Faces to keep: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
  /** Edges: the faces beside them: a list of edges, each by id or by `[a, b]`, the vertices at its ends; default: the selected edges. */
  edges?: (number | Pair)[];
  /** Vertices: the faces around them: a list of vertices, each by id; default: the selected vertices. */
  vertices?: number[];
}

/** Build the mesh again from the faces of its file, with other repairs; edits made since are lost. */
export interface RepairImport {
  op: "repair-import";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Faces at edges where more than two meet: separate them all, or keep only the first two: one of `"separate"`, `"drop"`; default: separate. */
  non_manifold?: "separate" | "drop";
  /** Merge vertices within this distance of each other, in mesh units: a number in mesh units, 0 or more; default: none. */
  merge_by_distance?: number;
  /** Orient faces consistently: `true` or `false`; default: true. */
  orient?: boolean;
}

/** Start a new document with a shape, or add the shape to this one. */
export interface New {
  op: "new";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Which shape: one of `"cube"`, `"tetrahedron"`, `"octahedron"`, `"icosahedron"`, `"dodecahedron"`, `"uv-sphere"`, `"ico-sphere"`, `"torus"`, `"cylinder"`, `"cone"`, `"plane"`, `"grid"`, `"teapot"`, `"bezier-curve"`, `"bezier-patch"`; required. */
  shape: "cube" | "tetrahedron" | "octahedron" | "icosahedron" | "dodecahedron" | "uv-sphere" | "ico-sphere" | "torus" | "cylinder" | "cone" | "plane" | "grid" | "teapot" | "bezier-curve" | "bezier-patch";
  /** Add it to this document instead of starting a new one: `true` or `false`; default: false. */
  add?: boolean;
  /** The length of its sides: a number, for shapes that have this size; default: 2 for cube, 2 for plane, 2 for grid, 2 for teapot, 2 for bezier-curve, 2 for bezier-patch. */
  size?: number;
  /** The radius, from the centre or axis: a number, for shapes that have this size; default: 1 for tetrahedron, 1 for octahedron, 1 for icosahedron, 1 for dodecahedron, 1 for uv-sphere, 1 for ico-sphere, 1 for torus, 1 for cylinder, 1 for cone. */
  radius?: number;
  /** The radius of a torus's tube: a number, for shapes that have this size; default: 0.4 for torus. */
  tube_radius?: number;
  /** The height of the shape: a number, for shapes that have this size; default: 2 for cylinder, 2 for cone. */
  height?: number;
  /** The number of faces around the axis: a number, for shapes that have this size; default: 32 for uv-sphere, 48 for torus, 32 for cylinder, 32 for cone, 8 for teapot. */
  segments?: number;
  /** The number of faces around the tube: a number, for shapes that have this size; default: 24 for torus. */
  tube_segments?: number;
  /** The number of rows of faces: a number, for shapes that have this size; default: 16 for uv-sphere, 1 for cylinder. */
  rings?: number;
  /** How many times to subdivide an icosahedron: a number, for shapes that have this size; default: 3 for ico-sphere. */
  subdivisions?: number;
  /** The number of faces in a row: a number, for shapes that have this size; default: 10 for grid. */
  columns?: number;
  /** The number of rows of faces: a number, for shapes that have this size; default: 10 for grid. */
  rows?: number;
  /** The degree of a Bezier curve, which has one control point more: a number, for shapes that have this size; default: 3 for bezier-curve. */
  degree?: number;
}

/** Make an object active: lists, selection and commands refer to it. */
export interface ActivateObject {
  op: "activate-object";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
}

/** Give an object another name. */
export interface RenameObject {
  op: "rename-object";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The new name: text; required. */
  name: string;
}

/** Show an object in the viewport or hide it. */
export interface SetObjectVisible {
  op: "set-object-visible";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Whether it is shown: `true` or `false`; required. */
  visible: boolean;
}

/** Delete an object. */
export interface DeleteObject {
  op: "delete-object";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
}

/** Join several objects into one; no vertices are merged. */
export interface JoinObjects {
  op: "join-objects";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The objects to join: a list of objects by their places, from 0; default: all objects. */
  objects?: number[];
}

/** Split an object into several: its connected pieces, its face groups, or some faces and the rest. */
export interface Separate {
  op: "separate";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** How to divide the object into parts: one of `"components"`, `"groups"`, `"faces"`; default: the selected faces, or connected pieces. */
  by?: "components" | "groups" | "faces";
  /** The faces that become an object: a list of faces, each by id; default: the selected faces. */
  faces?: number[];
}

/** Make a mesh of quads from a Bezier surface, welded where patches meet. */
export interface BezierTessellate {
  op: "bezier-tessellate";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** How many quads lie along a patch's side: a whole number from 1 to 256; default: 8. */
  resolution?: number;
}

/** Move a control point of a curve or surface; points of patches at the same position move together. */
export interface BezierMovePoint {
  op: "bezier-move-point";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Which control point of a curve: a whole number, 0 or more; default: none, for a surface. */
  point?: number;
  /** Which patch of a surface: a whole number, 0 or more; default: none, for a curve. */
  patch?: number;
  /** Which row of the patch, 0 to 3: a whole number, 0 or more; default: none, for a curve. */
  row?: number;
  /** Which point of the row, 0 to 3: a whole number, 0 or more; default: none, for a curve. */
  column?: number;
  /** The new position: three numbers: `[x, y, z]`; required. */
  position: Vector;
}

/** Add a control point to a Bezier curve. */
export interface BezierInsertPoint {
  op: "bezier-insert-point";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The index that it gets: a whole number, 0 or more; default: after the last. */
  index?: number;
  /** The position of the point: three numbers: `[x, y, z]`; required. */
  position: Vector;
}

/** Delete a control point of a Bezier curve. */
export interface BezierDeletePoint {
  op: "bezier-delete-point";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** Which control point: a whole number, 0 or more; required. */
  index: number;
}

/** Add a control point to a Bezier curve without changing its shape. */
export interface BezierElevateDegree {
  op: "bezier-elevate-degree";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
}

/** Split a Bezier curve into two of the same degree. */
export interface BezierSplit {
  op: "bezier-split";
  /** The place of the object in the document's list; default: the active object. */
  object?: number;
  /** The parameter at which to split: a number above 0 and below 1; default: 0.5. */
  t?: number;
}

/** Any command. */
export type Command =
  | SetVertexPosition
  | Transform
  | SetFaceColor
  | SplitEdge
  | FlipEdge
  | CollapseEdge
  | CollapseFace
  | SplitVertex
  | DissolveVertex
  | DissolveEdge
  | DeleteFaces
  | DeleteVertices
  | TriangulateFaces
  | PokeFaces
  | ConnectVertices
  | ExtrudeFaces
  | ExtrudeEdges
  | InsetFaces
  | BevelEdges
  | BevelVertices
  | LoopCut
  | SlideEdges
  | SlideVertices
  | FillHole
  | Bridge
  | MergeVertices
  | WeldEdges
  | RipEdges
  | FlipOrientation
  | SetCrease
  | SubdivideCatmullClark
  | SubdivideLoop
  | SubdivideLinear
  | Simplify
  | Remesh
  | Smooth
  | MergeByDistance
  | SelectElements
  | SelectAll
  | SelectRelated
  | SelectBoundary
  | SelectSharpEdges
  | SelectByCorners
  | SelectByValence
  | SelectByArea
  | SelectByLength
  | SelectNonPlanar
  | SelectDegenerate
  | SelectIsolated
  | SelectSmallerComponents
  | SelectFacing
  | SelectSimilar
  | SelectNamed
  | NameSelection
  | RenameNamedSelection
  | DeleteNamedSelection
  | Hide
  | Reveal
  | Isolate
  | RepairImport
  | New
  | ActivateObject
  | RenameObject
  | SetObjectVisible
  | DeleteObject
  | JoinObjects
  | Separate
  | BezierTessellate
  | BezierMovePoint
  | BezierInsertPoint
  | BezierDeletePoint
  | BezierElevateDegree
  | BezierSplit;

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
