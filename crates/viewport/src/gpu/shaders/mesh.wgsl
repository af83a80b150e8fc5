// Faces, lit by a studio's lights or by one at the camera, and the wireframe over them.

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
    let sky = 0.33 + 0.08 * n.y;
    return min(sky + 0.66 * key + 0.22 * fill + 0.2 * rim, 1.0);
}

@fragment
fn mesh_fragment(in: MeshVertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    // Sides that cross in pixels: how fast each barycentric coordinate changes per pixel. Taken
    // first, in uniform control flow, as derivatives must be.
    let dx = dpdx(in.barycentric);
    let dy = dpdy(in.barycentric);
    let slope = max(sqrt(dx * dx + dy * dy), vec3<f32>(1e-9));

    var to_light = normalize(-in.relative);
    if frame.light.w > 0.5 {
        to_light = frame.light.xyz;
    }
    var normal = to_light;
    let length = length(in.normal);
    if length > 0.01 {
        normal = in.normal / length;
        if !front {
            normal = -normal;
        }
    }
    var color = in.color.rgb;
    if !front {
        color = mix(color * 0.5, frame.back_face.rgb, 0.5);
    }
    var share = 0.2 + 0.8 * max(dot(normal, to_light), 0.0);
    if frame.right.w > 0.5 {
        let towards = cross(frame.right.xyz, frame.up.xyz);
        share = studio(vec3<f32>(dot(normal, frame.right.xyz), dot(normal, frame.up.xyz), dot(normal, towards)));
    }
    color = color * share;

    // Side i runs from corner i to the next, opposite the corner before: where that corner's
    // coordinate is 0.
    let away = max(in.barycentric, vec3<f32>(0.0)) / slope;
    let flags = u32(round(in.color.a * 255.0));
    let is_edge = vec3<f32>(
        f32((flags & 2u) != 0u),
        f32((flags & 4u) != 0u),
        f32((flags & 1u) != 0u),
    );
    // Lines fade where the triangle's height is but a few of their widths: a dense mesh keeps its
    // shading.
    let half_width = draw.params.x;
    let height = 1.0 / slope;
    let strength = smoothstep(vec3<f32>(half_width * 3.0), vec3<f32>(half_width * 12.0), height);
    let line = (1.0 - smoothstep(vec3<f32>(half_width - 0.5), vec3<f32>(half_width + 0.5), away))
        * is_edge * strength;
    let alpha = max(line.x, max(line.y, line.z)) * draw.params.y * frame.edge.a;
    return vec4<f32>(mix(color, frame.edge.rgb, alpha), 1.0);
}
