// Faces: Lambert with the light at the camera, and the wireframe over them.

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
    var facing = 1.0;
    let length = length(in.normal);
    if length > 0.01 {
        facing = dot(in.normal / length, to_light);
    }
    var color = in.color.rgb;
    if !front {
        facing = -facing;
        color = mix(color * 0.5, frame.back_face.rgb, 0.5);
    }
    color = color * (0.2 + 0.8 * max(facing, 0.0));

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
