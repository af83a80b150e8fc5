// The soft shadow of all objects on the ground: their faces drawn from above into a small map, the darker the closer
// they are to the ground, then blurred in two directions, then laid on the ground.

struct Cast {
    @builtin(position) clip: vec4<f32>,
    // Above the ground, in units of half the map's width.
    @location(0) height: f32,
}

// draw: the object's origin relative to the middle of the map, and 2 / the map's width; params: 1 where z points upwards.
@vertex
fn cast_vertex(@location(0) position: vec3<f32>) -> Cast {
    let p = from_eye(position);
    let place = select(p, vec3<f32>(p.x, p.z, -p.y), draw.params.x > 0.5);
    var out: Cast;
    out.clip = vec4<f32>(place.x, place.z, 0.5, 1.0);
    out.height = place.y;
    return out;
}

@fragment
fn cast_fragment(in: Cast) -> @location(0) vec4<f32> {
    let close = 1.0 - clamp(in.height * 0.8, 0.0, 1.0);
    return vec4<f32>(close * close * close);
}

@group(1) @binding(0) var map: texture_2d<f32>;
@group(1) @binding(1) var clamped: sampler;

struct Place {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn blur_vertex(@builtin(vertex_index) index: u32) -> Place {
    let place = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    var out: Place;
    out.clip = vec4<f32>(place * 2.0 - 1.0, 0.0, 1.0);
    out.uv = vec2<f32>(place.x, 1.0 - place.y);
    return out;
}

// A Gaussian of 4% of the map's width, cut off after three of them.
fn blurred(uv: vec2<f32>, along: vec2<f32>) -> vec4<f32> {
    var sum = 0.0;
    var weights = 0.0;
    for (var i = -12; i <= 12; i++) {
        let at = f32(i) / 4.0;
        let weight = exp(-0.5 * at * at);
        sum += textureSampleLevel(map, clamped, uv + along * (at * 0.04), 0.0).r * weight;
        weights += weight;
    }
    return vec4<f32>(sum / weights);
}

@fragment
fn blur_across(in: Place) -> @location(0) vec4<f32> {
    return blurred(in.uv, vec2<f32>(1.0, 0.0));
}

@fragment
fn blur_along(in: Place) -> @location(0) vec4<f32> {
    return blurred(in.uv, vec2<f32>(0.0, 1.0));
}

// draw: the middle of the map; params: half its width.
@vertex
fn shadow_vertex(@builtin(vertex_index) index: u32) -> Place {
    let right = index == 1u || index == 2u || index == 4u;
    let far = index == 2u || index == 4u || index == 5u;
    let corner = vec2<f32>(select(-1.0, 1.0, right), select(-1.0, 1.0, far));
    var out: Place;
    out.clip = to_clip(from_eye(to_scene(vec3<f32>(corner.x, 0.0, corner.y)) * draw.params.x));
    out.uv = vec2<f32>(corner.x, -corner.y) * 0.5 + 0.5;
    return out;
}

@fragment
fn shadow_fragment(in: Place) -> @location(0) vec4<f32> {
    return vec4<f32>(draw.color.rgb, draw.color.a * textureSampleLevel(map, clamped, in.uv, 0.0).r);
}
