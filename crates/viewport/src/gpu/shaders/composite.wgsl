// Puts the finished picture into the page's render pass, pixel for pixel.

@group(0) @binding(0) var picture: texture_2d<f32>;

struct Place {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn composite_vertex(@builtin(vertex_index) index: u32) -> Place {
    let place = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    var out: Place;
    out.clip = vec4<f32>(place * 2.0 - 1.0, 0.0, 1.0);
    out.uv = vec2<f32>(place.x, 1.0 - place.y);
    return out;
}

fn pixel(uv: vec2<f32>) -> vec4<f32> {
    let size = vec2<i32>(textureDimensions(picture));
    let at = clamp(vec2<i32>(floor(uv * vec2<f32>(size))), vec2<i32>(0), size - vec2<i32>(1));
    return vec4<f32>(textureLoad(picture, at, 0).rgb, 1.0);
}

// For targets that show what is written.
@fragment
fn composite_gamma(in: Place) -> @location(0) vec4<f32> {
    return pixel(in.uv);
}

// For targets that encode what is written.
@fragment
fn composite_linear(in: Place) -> @location(0) vec4<f32> {
    let color = pixel(in.uv).rgb;
    let low = color / 12.92;
    let high = pow((color + 0.055) / 1.055, vec3<f32>(2.4));
    return vec4<f32>(select(high, low, color <= vec3<f32>(0.04045)), 1.0);
}
