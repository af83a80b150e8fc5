// What all looks of faces share: which way they face, the studio's light, and the wireframe.

// The direction to the eye from a place relative to it.
fn towards_eye(relative: vec3<f32>) -> vec3<f32> {
    return select(normalize(-relative), frame.light.xyz, frame.light.w > 0.5);
}

// The unit normal of the front side, from one that is interpolated; where there is none, it points to the eye.
fn outwards(normal: vec3<f32>, to_eye: vec3<f32>) -> vec3<f32> {
    return select(to_eye, normal / max(length(normal), 0.01), length(normal) > 0.01);
}

// The normal of the side that is seen.
fn facing(outward: vec3<f32>, normal: vec3<f32>, front: bool) -> vec3<f32> {
    return select(-outward, outward, front || length(normal) <= 0.01);
}

// To the right, up and towards the camera.
fn in_camera(direction: vec3<f32>) -> vec3<f32> {
    let towards = cross(frame.right.xyz, frame.up.xyz);
    return vec3<f32>(dot(direction, frame.right.xyz), dot(direction, frame.up.xyz), dot(direction, towards));
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

// The barycentric coordinates of a triangle's corner.
fn barycentric_of(index: u32) -> vec3<f32> {
    let corner = index % 3u;
    return vec3<f32>(f32(corner == 0u), f32(corner == 1u), f32(corner == 2u));
}

// How fast each barycentric coordinate changes per pixel, for sides that cross in pixels. Only in uniform control flow, as
// derivatives must be.
fn slopes(barycentric: vec3<f32>) -> vec3<f32> {
    let dx = dpdx(barycentric);
    let dy = dpdy(barycentric);
    return max(sqrt(dx * dx + dy * dy), vec3<f32>(1e-9));
}

// A face's colour with the wireframe over it. `flags` says which sides are edges; lines are at least as strong as `least`.
// draw.params: half the width of lines, whether there are any, and how translucent faces are.
fn with_edges(color: vec3<f32>, flags: f32, barycentric: vec3<f32>, slope: vec3<f32>, least: f32) -> vec4<f32> {
    // Side i runs from corner i to the next, opposite the corner before: where that corner's
    // coordinate is 0.
    let away = max(barycentric, vec3<f32>(0.0)) / slope;
    let sides = u32(round(flags * 255.0));
    let is_edge = vec3<f32>(
        f32((sides & 2u) != 0u),
        f32((sides & 4u) != 0u),
        f32((sides & 1u) != 0u),
    );
    // Lines fade where the triangle's height is but a few of their widths: a dense mesh keeps its shading, and
    // its lines make no moiré.
    let half_width = draw.params.x;
    let height = 1.0 / slope;
    let strength = max(smoothstep(vec3<f32>(half_width * 4.0), vec3<f32>(half_width * 24.0), height), vec3<f32>(least));
    let line = (1.0 - smoothstep(vec3<f32>(half_width - 0.5), vec3<f32>(half_width + 0.5), away))
        * is_edge * strength;
    let alpha = max(line.x, max(line.y, line.z)) * draw.params.y * frame.edge.a;
    return vec4<f32>(mix(color, frame.edge.rgb, alpha), 1.0 - draw.params.z * (1.0 - alpha));
}
