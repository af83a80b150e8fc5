// Shared by all shaders of the scene. Positions are relative to the eye and in units of the
// distance to the target, colours are sRGB as shown: blending and multisampling work on those, as
// the page's own do.

struct Frame {
    matrix: mat4x4<f32>,
    light: vec4<f32>,
    right: vec4<f32>,
    up: vec4<f32>,
    viewport: vec4<f32>,
    background_top: vec4<f32>,
    background_bottom: vec4<f32>,
    edge: vec4<f32>,
    back_face: vec4<f32>,
    grid_color: vec4<f32>,
    grid: vec4<f32>,
    grid_fade: vec4<f32>,
}

struct Draw {
    offset: vec4<f32>,
    color: vec4<f32>,
    params: vec4<f32>,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<uniform> draw: Draw;

// A vector of the scene, from one whose y points upwards.
fn to_scene(v: vec3<f32>) -> vec3<f32> {
    return select(v, vec3<f32>(v.x, -v.z, v.y), frame.up.w > 0.5);
}

// A position of the object's buffers, relative to the eye.
fn from_eye(position: vec3<f32>) -> vec3<f32> {
    return (position + draw.offset.xyz) * draw.offset.w;
}

fn to_clip(relative: vec3<f32>) -> vec4<f32> {
    return frame.matrix * vec4<f32>(relative, 1.0);
}

// Pixels from the middle of the viewport, y up.
fn to_pixels(clip: vec4<f32>) -> vec2<f32> {
    return clip.xy / clip.w * frame.viewport.xy * 0.5;
}

fn from_pixels(pixels: vec2<f32>, clip: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(pixels / (frame.viewport.xy * 0.5) * clip.w, clip.z, clip.w);
}

// A clip position this many pixels nearer to the eye than it is: what lies on a surface is drawn in front of it.
fn nearer(clip: vec4<f32>, pixels: f32) -> vec4<f32> {
    let up = vec3<f32>(frame.matrix[0].y, frame.matrix[1].y, frame.matrix[2].y);
    let along = vec3<f32>(frame.matrix[0].z, frame.matrix[1].z, frame.matrix[2].z);
    // In units of the distance to the target; in perspective as a fraction of the depth, which the reversed depth is the
    // inverse of.
    let by = pixels * 2.0 / (length(up) * frame.viewport.y);
    let is_perspective = f32(frame.light.w < 0.5);
    return vec4<f32>(clip.xy, clip.z * (1.0 + by * is_perspective) + by * length(along), clip.w);
}

// Nothing at this clip position is drawn.
fn nowhere() -> vec4<f32> {
    return vec4<f32>(2.0, 2.0, 0.5, 1.0);
}
