// Faces in all looks but those of texture coordinates.

struct MeshVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) relative: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) barycentric: vec3<f32>,
}

@vertex
fn mesh_vertex(
    @builtin(vertex_index) index: u32,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec4<f32>,
    @location(2) color: vec4<f32>,
) -> MeshVertex {
    var out: MeshVertex;
    out.relative = from_eye(position);
    out.clip = to_clip(out.relative);
    out.normal = normal.xyz;
    out.color = color;
    out.barycentric = barycentric_of(index);
    return out;
}

// The looks, as numbered in uniforms.rs.
const COURSE: i32 = 0;
const STUDIO: i32 = 1;
const MATCAP: i32 = 2;
const ZEBRA: i32 = 3;
const HIDDEN_LINE: i32 = 5;
const NORMALS: i32 = 6;
const ORIENTATION: i32 = 7;
// Those of texture coordinates are as the studio where a mesh has none.
const TEXTURE: i32 = 8;
const CHECKER: i32 = 9;

// The colour of unpainted faces, which matcaps show as they are.
const UNPAINTED: f32 = 0.7843;
// Zebra stripes from the lowest to the highest direction.
const STRIPES: f32 = 9.0;

@group(1) @binding(0) var matcap: texture_2d<f32>;
@group(1) @binding(1) var clamped: sampler;

// The place in a matcap for a normal seen along a direction, both in the camera's frame: beside the middle of the
// picture, too, a normal towards the eye is in the middle.
fn matcap_place(normal: vec3<f32>, to_eye: vec3<f32>) -> vec2<f32> {
    let right = normalize(vec3<f32>(to_eye.z, 0.0, -to_eye.x));
    let up = cross(to_eye, right);
    return vec2<f32>(dot(normal, right), -dot(normal, up)) * 0.495 + 0.5;
}

@fragment
fn mesh_fragment(in: MeshVertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let slope = slopes(in.barycentric);
    let to_eye = towards_eye(in.relative);
    let outward = outwards(in.normal, to_eye);
    let normal = facing(outward, in.normal, front);
    let seen = in_camera(normal);
    let mirrored = reflect(-in_camera(to_eye), seen);
    let stripe_at = acos(clamp(mirrored.y, -1.0, 1.0)) * (STRIPES / 3.14159265);
    let stripe_slope = max(fwidth(stripe_at), 1e-4);

    let look = i32(frame.right.w + 0.5);
    var color = in.color.rgb;
    if look == COURSE {
        color *= 0.2 + 0.8 * max(dot(normal, to_eye), 0.0);
    } else if look == STUDIO || look == TEXTURE || look == CHECKER {
        color *= studio(seen);
    } else if look == MATCAP {
        let lit = textureSampleLevel(matcap, clamped, matcap_place(seen, in_camera(to_eye)), 0.0).rgb;
        color = lit * color / UNPAINTED;
    } else if look == ZEBRA {
        let stripe = abs(fract(stripe_at) - 0.5) * 2.0;
        let white = smoothstep(0.5 - stripe_slope, 0.5 + stripe_slope, stripe);
        // Stripes too narrow for their pixels are grey.
        color *= mix(0.12, 1.2, mix(white, 0.5, clamp(stripe_slope - 0.5, 0.0, 1.0)));
    }
    // The tint isn't lit, so that it is seen in the dark too. Through translucent faces one sees backs everywhere.
    if !front && draw.params.z == 0.0 {
        color = mix(color * 0.7, frame.back_face.rgb, 0.5);
    }
    if look == HIDDEN_LINE {
        color = mix(frame.background_top, frame.background_bottom, in.clip.y / frame.viewport.y).rgb;
    } else if look == NORMALS {
        color = outward * 0.5 + 0.5;
    } else if look == ORIENTATION {
        color = select(vec3<f32>(0.91, 0.26, 0.26), vec3<f32>(0.27, 0.50, 0.96), front) * (0.35 + 0.65 * studio(seen));
    }
    // Without shading, some of the lines have to stay.
    return with_edges(color, in.color.a, in.barycentric, slope, select(0.0, 0.3, look == HIDDEN_LINE));
}
