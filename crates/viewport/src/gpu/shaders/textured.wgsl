// Faces with what lies at their texture coordinates: the pictures of materials, or a chequered pattern.

struct TexturedVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) relative: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) barycentric: vec3<f32>,
    // v counts from the top.
    @location(4) uv: vec2<f32>,
    // The texture's place in this pass, or one of the numbers below.
    @location(5) @interpolate(flat) place: i32,
}

// Without texture coordinates.
const BARE: i32 = -2;
// With texture coordinates, without a texture.
const UNTEXTURED: i32 = -1;

// The look, as numbered in uniforms.rs.
const CHECKER: i32 = 9;

// The textures of a pass, as many as in materials.rs.
const PLACES: i32 = 8;

struct Placement {
    // The rows of the transform of texture coordinates; the first ends with the least alpha that shows, the second with the
    // opacity.
    u: vec4<f32>,
    v: vec4<f32>,
}

@group(1) @binding(0) var<uniform> placements: array<Placement, 8>;
@group(1) @binding(1) var texture0: texture_2d<f32>;
@group(1) @binding(2) var texture1: texture_2d<f32>;
@group(1) @binding(3) var texture2: texture_2d<f32>;
@group(1) @binding(4) var texture3: texture_2d<f32>;
@group(1) @binding(5) var texture4: texture_2d<f32>;
@group(1) @binding(6) var texture5: texture_2d<f32>;
@group(1) @binding(7) var texture6: texture_2d<f32>;
@group(1) @binding(8) var texture7: texture_2d<f32>;
@group(1) @binding(9) var sampler0: sampler;
@group(1) @binding(10) var sampler1: sampler;
@group(1) @binding(11) var sampler2: sampler;
@group(1) @binding(12) var sampler3: sampler;
@group(1) @binding(13) var sampler4: sampler;
@group(1) @binding(14) var sampler5: sampler;
@group(1) @binding(15) var sampler6: sampler;
@group(1) @binding(16) var sampler7: sampler;

// Less than any texture coordinate: there is none, see materials.rs.
const MISSING_UV: f32 = -1e8;

// draw.params.w is the number of the pass's first texture. The first pass draws the faces without one too. Faces of
// translucent materials are drawn by themselves, unless all faces are translucent.
struct Corner {
    @builtin(vertex_index) index: u32,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec4<f32>,
    @location(2) color: vec4<f32>,
    @location(3) uv: vec2<f32>,
}

@vertex
fn textured_vertex(corner: Corner) -> TexturedVertex {
    return vertex_of(corner, draw.params.z > 0.0, true);
}

@vertex
fn translucent_vertex(corner: Corner) -> TexturedVertex {
    return vertex_of(corner, true, false);
}

fn vertex_of(corner: Corner, draws_translucent: bool, draws_opaque: bool) -> TexturedVertex {
    var out: TexturedVertex;
    out.relative = from_eye(corner.position);
    out.normal = corner.normal.xyz;
    out.color = corner.color;
    out.barycentric = barycentric_of(corner.index);
    out.uv = corner.uv;
    let mark = i32(round(corner.normal.w * 32767.0)) - 2;
    let first = i32(draw.params.w);
    out.place = mark;
    var is_drawn = first == 0 && draws_opaque;
    if mark >= 0 {
        out.place = mark - first;
        is_drawn = out.place >= 0 && out.place < PLACES;
        if is_drawn {
            let is_translucent = placements[out.place].v.w < 1.0;
            is_drawn = select(draws_opaque, draws_translucent, is_translucent);
        }
        if is_drawn && i32(frame.right.w + 0.5) != CHECKER {
            let placement = placements[out.place];
            let at = vec3<f32>(corner.uv, 1.0);
            out.uv = vec2<f32>(dot(placement.u.xyz, at), dot(placement.v.xyz, at));
        }
    }
    if is_drawn {
        out.clip = to_clip(out.relative);
    } else {
        out.clip = nowhere();
    }
    return out;
}

// The picture at this place, in linear light. WebGL2 has no arrays of textures of different sizes.
fn look_up(place: i32, uv: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>) -> vec4<f32> {
    switch place {
        case 0: { return textureSampleGrad(texture0, sampler0, uv, dx, dy); }
        case 1: { return textureSampleGrad(texture1, sampler1, uv, dx, dy); }
        case 2: { return textureSampleGrad(texture2, sampler2, uv, dx, dy); }
        case 3: { return textureSampleGrad(texture3, sampler3, uv, dx, dy); }
        case 4: { return textureSampleGrad(texture4, sampler4, uv, dx, dy); }
        case 5: { return textureSampleGrad(texture5, sampler5, uv, dx, dy); }
        case 6: { return textureSampleGrad(texture6, sampler6, uv, dx, dy); }
        default: { return textureSampleGrad(texture7, sampler7, uv, dx, dy); }
    }
}

fn to_linear(color: vec3<f32>) -> vec3<f32> {
    return select(pow((color + 0.055) / 1.055, vec3<f32>(2.4)), color / 12.92, color <= vec3<f32>(0.04045));
}

fn to_srgb(color: vec3<f32>) -> vec3<f32> {
    return select(1.055 * pow(color, vec3<f32>(1.0 / 2.4)) - 0.055, color * 12.92, color <= vec3<f32>(0.0031308));
}

// Light and dark cells, an eighth of the picture wide, redder to the right and greener to the top: one sees where a face
// lies in the picture, and whether it is mirrored.
fn checker(uv: vec2<f32>, width: vec2<f32>) -> vec3<f32> {
    let cell = uv * 8.0;
    // Each coordinate's distance from the middle of its cell, of both kinds of cell: 1 in one, -1 in the other.
    let side = (0.5 - abs(fract(cell * 0.5 + 0.25) - 0.5)) * 4.0 - 1.0;
    let slope = max(width * 16.0, vec2<f32>(1e-4));
    let sharp = clamp(side / slope, vec2<f32>(-1.0), vec2<f32>(1.0));
    // Cells too narrow for their pixels are grey.
    let fade = clamp(1.5 - max(width.x, width.y) * 8.0, 0.0, 1.0);
    let light = 0.62 + 0.2 * sharp.x * sharp.y * fade;
    let at = fract(uv);
    let tint = vec3<f32>(0.72 + 0.5 * at.x, 1.22 - 0.5 * at.y, 0.95);
    return light * mix(vec3<f32>(1.0), tint, fade);
}

@fragment
fn textured_fragment(in: TexturedVertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let slope = slopes(in.barycentric);
    let dx = dpdx(in.uv);
    let dy = dpdy(in.uv);
    let to_eye = towards_eye(in.relative);
    let outward = outwards(in.normal, to_eye);
    let light = studio(in_camera(facing(outward, in.normal, front)));

    var color = in.color.rgb;
    if i32(frame.right.w + 0.5) == CHECKER {
        if in.place != BARE && in.uv.x > MISSING_UV {
            color = checker(in.uv, abs(dx) + abs(dy));
        }
        color *= light;
    } else if in.place >= 0 {
        let texel = look_up(in.place, in.uv, dx, dy);
        if texel.a < placements[in.place].u.w {
            discard;
        }
        // Pictures have light of their own: softer than on plain faces.
        color = to_srgb(texel.rgb * to_linear(color)) * mix(light, 1.0, 0.3);
    } else {
        color *= light;
    }
    // Pictures have no blue of backs, which would be taken for theirs.
    if !front && draw.params.z == 0.0 {
        color *= 0.7;
    }
    var shown = with_edges(color, in.color.a, in.barycentric, slope, 0.0);
    if in.place >= 0 {
        shown.a *= placements[in.place].v.w;
    }
    return shown;
}
