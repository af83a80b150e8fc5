// Faces in all looks, and the wireframe over them.

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
    let corner = index % 3u;
    out.barycentric = vec3<f32>(f32(corner == 0u), f32(corner == 1u), f32(corner == 2u));
    return out;
}

// The share of its colour that a face shows under the studio's lights. They are fixed to the camera: `n` is the
// normal to the right, up and towards the camera. Colours are sRGB, so the shares are as seen.
fn studio(n: vec3<f32>) -> f32 {
    let key = max(dot(n, vec3<f32>(-0.380, 0.530, 0.758)), 0.0);
    let fill = max(dot(n, vec3<f32>(0.873, 0.0, 0.487)), 0.0);
    let rim = max(dot(n, vec3<f32>(0.196, 0.588, -0.785)), 0.0);
    let sky = 0.33 + 0.09 * n.y;
    return min(sky + 0.56 * key + 0.20 * fill + 0.2 * rim, 1.0);
}

// The looks, as numbered in uniforms.rs.
const COURSE: i32 = 0;
const STUDIO: i32 = 1;
const MATCAP: i32 = 2;
const ZEBRA: i32 = 3;
const HIDDEN_LINE: i32 = 5;
const NORMALS: i32 = 6;
const ORIENTATION: i32 = 7;

// The colour of unpainted faces, which matcaps show as they are.
const UNPAINTED: f32 = 0.7843;
// Zebra stripes from the lowest to the highest direction.
const STRIPES: f32 = 9.0;

@group(1) @binding(0) var matcap: texture_2d<f32>;
@group(1) @binding(1) var clamped: sampler;

// To the right, up and towards the camera.
fn in_camera(direction: vec3<f32>) -> vec3<f32> {
    let towards = cross(frame.right.xyz, frame.up.xyz);
    return vec3<f32>(dot(direction, frame.right.xyz), dot(direction, frame.up.xyz), dot(direction, towards));
}

// The place in a matcap for a normal seen along a direction, both in the camera's frame: beside the middle of the
// picture, too, a normal towards the eye is in the middle.
fn matcap_place(normal: vec3<f32>, to_eye: vec3<f32>) -> vec2<f32> {
    let right = normalize(vec3<f32>(to_eye.z, 0.0, -to_eye.x));
    let up = cross(to_eye, right);
    return vec2<f32>(dot(normal, right), -dot(normal, up)) * 0.495 + 0.5;
}

// params: half the width of lines, whether there are any, and how translucent faces are.
@fragment
fn mesh_fragment(in: MeshVertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    // Sides that cross in pixels: how fast each barycentric coordinate changes per pixel. Taken
    // first, in uniform control flow, as derivatives must be.
    let dx = dpdx(in.barycentric);
    let dy = dpdy(in.barycentric);
    let slope = max(sqrt(dx * dx + dy * dy), vec3<f32>(1e-9));

    var to_eye = normalize(-in.relative);
    if frame.light.w > 0.5 {
        to_eye = frame.light.xyz;
    }
    var outward = to_eye;
    let length = length(in.normal);
    if length > 0.01 {
        outward = in.normal / length;
    }
    let normal = select(-outward, outward, front || length <= 0.01);
    let seen = in_camera(normal);
    let mirrored = reflect(-in_camera(to_eye), seen);
    let stripe_at = acos(clamp(mirrored.y, -1.0, 1.0)) * (STRIPES / 3.14159265);
    let stripe_slope = max(fwidth(stripe_at), 1e-4);

    let look = i32(frame.right.w + 0.5);
    var color = in.color.rgb;
    if look == COURSE {
        color *= 0.2 + 0.8 * max(dot(normal, to_eye), 0.0);
    } else if look == STUDIO {
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

    // Side i runs from corner i to the next, opposite the corner before: where that corner's
    // coordinate is 0.
    let away = max(in.barycentric, vec3<f32>(0.0)) / slope;
    let flags = u32(round(in.color.a * 255.0));
    let is_edge = vec3<f32>(
        f32((flags & 2u) != 0u),
        f32((flags & 4u) != 0u),
        f32((flags & 1u) != 0u),
    );
    // Lines fade where the triangle's height is but a few of their widths: a dense mesh keeps its shading, and
    // its lines make no moiré. Without shading, some of them has to stay.
    let half_width = draw.params.x;
    let height = 1.0 / slope;
    let least = select(0.0, 0.3, look == HIDDEN_LINE);
    let strength = max(smoothstep(vec3<f32>(half_width * 4.0), vec3<f32>(half_width * 24.0), height), vec3<f32>(least));
    let line = (1.0 - smoothstep(vec3<f32>(half_width - 0.5), vec3<f32>(half_width + 0.5), away))
        * is_edge * strength;
    let alpha = max(line.x, max(line.y, line.z)) * draw.params.y * frame.edge.a;
    return vec4<f32>(mix(color, frame.edge.rgb, alpha), 1.0 - draw.params.z * (1.0 - alpha));
}
