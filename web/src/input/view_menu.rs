//! The View menu.

use viewport::{ColorBy, Look, Mark, Matcap, Side, UpAxis};

use super::action::{Action as A, Entry, entry};
use super::camera_style::{CameraStyle, OrbitAbout};
use crate::shown::Arrangement;
use crate::view::pane::Split;

const fn scale(percent: u16, label: &'static str) -> Option<Entry> {
    let entry = entry(A::InterfaceScale(percent), label, "Scale texts and controls to this size.");
    Some(entry.synonyms(&["interface scale", "ui scale", "zoom"]))
}

/// An entry that has other names in other programs.
const fn also(
    action: A,
    label: &'static str,
    description: &'static str,
    synonyms: &'static [&'static str],
) -> Option<Entry> {
    Some(entry(action, label, description).synonyms(synonyms))
}

/// Other words for several views.
const SPLITS: &[&str] = &["quad view", "split", "layout of views", "four-up", "multiple viewports"];

/// Other words for the styles of the camera.
const NAVIGATION: &[&str] = &["navigation", "orbit", "mouse"];

/// Its entries.
pub(super) static ENTRIES: &[Option<Entry>] = &[
    also(
        A::Frame,
        "Frame selection",
        "Fit the selection into the view, or everything if nothing is selected.",
        &["zoom to selection", "focus"],
    ),
    also(
        A::FrameAll,
        "Frame all",
        "Fit everything into the view, from the same direction.",
        &["zoom to fit", "view all"],
    ),
    also(A::ZoomIn, "Zoom in", "Zoom in on the middle of the view.", &["closer", "larger"]),
    also(A::ZoomOut, "Zoom out", "Zoom out from the middle of the view.", &["farther", "smaller"]),
    also(
        A::Fly,
        "Fly",
        "Fly through the scene with W, A, S, D, and the pointer.",
        &["walk", "first person", "game navigation", "wasd"],
    ),
    Some(entry(A::ResetView, "Reset view", "Restore the initial view.")),
    Some(entry(A::LookFrom(Side::Front), "Front view", "Look from the front, along an axis.")),
    Some(entry(A::LookFrom(Side::Back), "Back view", "Look from the back, along an axis.")),
    Some(entry(A::LookFrom(Side::Right), "Right view", "Look from the right, along an axis.")),
    Some(entry(A::LookFrom(Side::Left), "Left view", "Look from the left, along an axis.")),
    Some(entry(A::LookFrom(Side::Top), "Top view", "Look from above, along an axis.")),
    Some(entry(A::LookFrom(Side::Bottom), "Bottom view", "Look from below, along an axis.")),
    also(
        A::AlignView,
        "Align view to selection",
        "Look straight at the selected faces, or at the faces around the selection.",
        &["align view to active", "look at", "normal to", "face view"],
    ),
    also(
        A::UpAxis(UpAxis::Y),
        "Y up",
        "Show the scene with y pointing upwards. Coordinates stay.",
        &["orientation", "vertical"],
    ),
    also(
        A::UpAxis(UpAxis::Z),
        "Z up",
        "Show the scene with z pointing upwards, as in Blender and CAD programs. Coordinates stay.",
        &["orientation", "vertical"],
    ),
    also(A::Orthographic, "Parallel projection", "Draw without perspective.", &["orthographic"]),
    also(
        A::Views(Split::One),
        "One view",
        "Show the active view in the whole viewport.",
        &["maximize", "single view"],
    ),
    also(
        A::Views(Split::Two),
        "Two views",
        "Split the viewport into two views side by side, or show one again.",
        SPLITS,
    ),
    also(
        A::Views(Split::Four),
        "Four views",
        "Split the viewport: from above, from the front, from the right, in perspective. Or show one view again.",
        SPLITS,
    ),
    also(
        A::CameraOfKeys,
        "Camera of the keys",
        "Use the camera style that belongs to the chosen keys.",
        NAVIGATION,
    ),
    also(
        A::Camera(CameraStyle::Course),
        "Course camera",
        "Orbit with a drag beside the mesh, pan with the right button.",
        NAVIGATION,
    ),
    also(
        A::Camera(CameraStyle::Blender),
        "Blender camera",
        "Orbit with the middle button, with Shift pan, with Ctrl zoom.",
        NAVIGATION,
    ),
    also(
        A::Camera(CameraStyle::Maya),
        "Maya camera",
        "With Alt held, orbit with the left button, pan with the middle one, zoom with the right one.",
        NAVIGATION,
    ),
    also(
        A::Camera(CameraStyle::Cad),
        "CAD camera",
        "Orbit about the point under the pointer with the right button, pan with the middle one.",
        &["navigation", "orbit", "mouse", "solidworks", "fusion", "onshape"],
    ),
    also(
        A::Camera(CameraStyle::Trackpad),
        "Trackpad camera",
        "Orbit with two fingers on the trackpad, with Shift pan, with Ctrl or a pinch zoom.",
        &["navigation", "orbit", "touchpad", "laptop", "scroll", "emulate 3 button mouse"],
    ),
    also(
        A::FreeRotation,
        "Free rotation",
        "Turn the view over the poles, about its own axes, instead of keeping the up axis upright.",
        &["trackball", "turntable", "roll", "tumble"],
    ),
    also(
        A::OrbitAbout(OrbitAbout::View),
        "Orbit about the middle",
        "Turn the view about its middle.",
        &["center of the view", "pivot"],
    ),
    also(
        A::OrbitAbout(OrbitAbout::Selection),
        "Orbit about the selection",
        "Turn the view about the middle of the selection, or of the view if nothing is selected.",
        &["orbit around selection", "pivot"],
    ),
    also(
        A::OrbitAbout(OrbitAbout::Pointer),
        "Orbit about the pointer",
        "Turn the view about the point of the surface where the drag begins.",
        &["auto depth", "pivot"],
    ),
    None,
    Some(entry(A::Wireframe, "Wireframe", "Draw edges over faces.").synonyms(&["edges"])),
    Some(entry(A::XRay, "X-ray", "See and select through surfaces.").synonyms(&[
        "transparent",
        "see through",
        "limit selection to visible",
        "occlude",
    ])),
    Some(entry(
        A::Smooth,
        "Smooth shading",
        "Shade with normals averaged at vertices instead of one per face.",
    )),
    auto_smooth(15, "Auto smooth at 15°"),
    auto_smooth(30, "Auto smooth at 30°"),
    auto_smooth(45, "Auto smooth at 45°"),
    auto_smooth(60, "Auto smooth at 60°"),
    auto_smooth(80, "Auto smooth at 80°"),
    also(
        A::ColorBy(ColorBy::Paint),
        "Paint",
        "Colour painted faces by their paint, the others by their vertices or material.",
        &["colour by"],
    ),
    Some(entry(A::ColorBy(ColorBy::Face), "Face colours", "Colour faces by their own colours only.")),
    also(
        A::ColorBy(ColorBy::Vertex),
        "Vertex colours",
        "Colour faces by the colours of their vertices only.",
        &["colour attribute", "per-vertex colour"],
    ),
    Some(entry(A::ColorBy(ColorBy::Uniform), "One colour", "Draw all faces in one colour.")),
    Some(entry(
        A::ColorBy(ColorBy::Material),
        "Material",
        "Give each material a colour that differs from the others, with a legend.",
    )),
    Some(entry(
        A::ColorBy(ColorBy::Group),
        "Group",
        "Give each group a colour that differs from the others, with a legend.",
    )),
    also(
        A::ColorBy(ColorBy::Valence),
        "Valence",
        "Colour vertices by their number of edges: blue has fewer than regular ones, red more.",
        &["degree", "poles"],
    ),
    Some(entry(
        A::ColorBy(ColorBy::GaussianCurvature),
        "Gaussian curvature",
        "Colour vertices by Gaussian curvature: blue at saddles, red at bulges and hollows.",
    )),
    also(
        A::ColorBy(ColorBy::MeanCurvature),
        "Mean curvature",
        "Colour vertices by mean curvature: blue in hollows, red at bulges.",
        &["convex", "concave", "cavity"],
    ),
    also(
        A::ColorBy(ColorBy::Quality),
        "Face quality",
        "Colour faces by how close they are to regular polygons: dark ones are slivers.",
        &["triangle shape", "aspect ratio", "slivers"],
    ),
    also(A::LookMenu, "Look menu", "Open the menu of looks at the pointer.", &["shading menu"]),
    also(
        A::Look(Look::Studio),
        "Studio lights",
        "Light faces with three lights fixed to the camera.",
        &["look", "solid"],
    ),
    also(
        A::Look(Look::Texture),
        "Textures",
        "Draw the images of materials on faces, lit as in a studio.",
        &["look", "material preview", "image", "map", "uv"],
    ),
    also(
        A::Look(Look::Course),
        "Light at the camera",
        "Light faces from the camera only, as the courses do.",
        &["look", "lambert", "headlight", "shading"],
    ),
    also(A::Look(Look::Matcap(Matcap::Clay)), "Clay", "Draw faces like terracotta.", &["look", "matcap"]),
    also(A::Look(Look::Matcap(Matcap::Pearl)), "Pearl", "Draw faces like white pearl.", &["look", "matcap"]),
    also(
        A::Look(Look::Matcap(Matcap::Metal)),
        "Metal",
        "Draw faces like steel, which shows unevenness.",
        &["look", "matcap", "chrome"],
    ),
    also(
        A::Look(Look::Matcap(Matcap::RedWax)),
        "Red wax",
        "Draw faces like glossy red wax.",
        &["look", "matcap", "sculpting"],
    ),
    also(
        A::Look(Look::Zebra),
        "Zebra stripes",
        "Mirror stripes on faces: they break or kink where the surface isn't smooth.",
        &["look", "reflection lines", "surface check"],
    ),
    also(
        A::Look(Look::Flat),
        "Colours without light",
        "Draw faces in their colours, without light.",
        &["look", "unlit", "flat colour"],
    ),
    also(
        A::Look(Look::HiddenLine),
        "Hidden line",
        "Draw edges only, hidden by the faces in front of them.",
        &["look", "technical drawing"],
    ),
    also(
        A::Look(Look::Normals),
        "Normals as colours",
        "Colour faces by their normals: x red, y green, z blue.",
        &["look"],
    ),
    also(
        A::Look(Look::Orientation),
        "Face orientation",
        "Draw the fronts of faces blue and the backs red.",
        &["look", "flipped normals", "inside out"],
    ),
    also(
        A::Look(Look::Checker),
        "UV checker",
        "Draw a checker pattern by texture coordinates: red grows to the right, green upwards.",
        &["look", "texture coordinates", "test grid", "distortion", "unwrap"],
    ),
    also(
        A::HideBacks,
        "Hide backs of faces",
        "Hide faces that are seen from the back.",
        &["backface culling", "cull"],
    ),
    also(
        A::Mark(Mark::Boundary),
        "Boundary edges",
        "Mark edges with a face on one side only in green.",
        &["holes", "open edges"],
    ),
    also(
        A::Mark(Mark::Sharp),
        "Sharp edges",
        "Mark creases, and edges whose faces meet at more than 30°, in blue.",
        &["creases", "hard edges"],
    ),
    also(
        A::Mark(Mark::Seam),
        "Texture seams",
        "Mark edges across which texture coordinates jump in red.",
        &["uv seams"],
    ),
    also(
        A::Mark(Mark::NonManifold),
        "Non-manifold places",
        "Mark edges and vertices that importing had to separate in magenta.",
        &["repaired", "separated"],
    ),
    also(
        A::Mark(Mark::FaceNormals),
        "Face normals",
        "Draw the normals of faces as lines.",
        &["normal lines"],
    ),
    also(
        A::Mark(Mark::VertexNormals),
        "Vertex normals",
        "Draw the normals of vertices as lines.",
        &["normal lines"],
    ),
    Some(entry(A::Dots, "Vertex dots", "Draw vertices as dots.")),
    Some(entry(A::Grid, "Ground grid", "Draw a grid on the ground below the model.")),
    also(
        A::Shadow,
        "Ground shadow",
        "Draw a soft shadow on the ground below the model.",
        &["contact shadow", "ambient occlusion"],
    ),
    Some(entry(
        A::Overlay,
        "Info overlay",
        "Show the selection and the element under the pointer in the viewport.",
    )),
    also(
        A::Numbers,
        "Element numbers",
        "Show the ids of the vertices (v), edges (e) and faces (f) around the pointer.",
        &["indices", "ids"],
    ),
    None,
    Some(entry(A::LeftPanel, "Element lists", "Show or hide the lists.")),
    Some(entry(A::RightPanel, "Inspector", "Show or hide the inspector and the operations.")),
    None,
    Some(entry(
        A::Arrange(Arrangement::Model),
        "Model layout",
        "Put tools and viewport first, and close the lists. Choose it again to restore its panels.",
    )),
    Some(entry(
        A::Arrange(Arrangement::Study),
        "Study layout",
        "Open lists, inspector, info overlay and element numbers, shaded as in the courses. Choose it again to restore its panels.",
    )),
    scale(80, "80 %"),
    scale(90, "90 %"),
    scale(100, "100 %"),
    scale(110, "110 %"),
    scale(125, "125 %"),
    scale(150, "150 %"),
];

const fn auto_smooth(degrees: u8, label: &'static str) -> Option<Entry> {
    let description = "Shade smoothly, but keep edges hard where faces meet at more than this angle.";
    let entry = entry(A::AutoSmooth(degrees), label, description);
    Some(entry.synonyms(&["shade smooth by angle", "soften edges", "hard edges"]))
}
