// Dots, lines and arrows of a size in pixels, and the fill of highlighted faces. The last of the params is always how many
// pixels nearer than it is something counts as.

struct Flat {
    @builtin(position) clip: vec4<f32>,
}

@vertex
fn fill_vertex(@location(0) position: vec3<f32>) -> Flat {
    var out: Flat;
    out.clip = nearer(to_clip(from_eye(position)), draw.params.w);
    return out;
}

@fragment
fn flat_fragment() -> @location(0) vec4<f32> {
    return draw.color;
}

// The corners of two triangles, -1 to 1.
fn quad(index: u32) -> vec2<f32> {
    let right = index == 1u || index == 2u || index == 4u;
    let top = index == 2u || index == 4u || index == 5u;
    return vec2<f32>(select(-1.0, 1.0, right), select(-1.0, 1.0, top));
}

struct Dot {
    @builtin(position) clip: vec4<f32>,
    @location(0) place: vec2<f32>,
}

// params: radius, rim width.
@vertex
fn dot_vertex(@builtin(vertex_index) index: u32, @location(0) position: vec3<f32>) -> Dot {
    var out: Dot;
    out.clip = to_clip(from_eye(position));
    let reach = draw.params.x + 1.0;
    out.place = quad(index) * reach;
    if position.x > 1e38 || out.clip.w < frame.viewport.w {
        out.clip = nowhere();
        return out;
    }
    out.clip = nearer(from_pixels(to_pixels(out.clip) + out.place, out.clip), draw.params.w);
    return out;
}

@fragment
fn dot_fragment(in: Dot) -> @location(0) vec4<f32> {
    let away = length(in.place);
    let alpha = draw.color.a * (1.0 - smoothstep(draw.params.x - 0.5, draw.params.x + 0.5, away));
    if alpha <= 0.0 {
        discard;
    }
    // A dark rim keeps dots apart from what is behind them, whatever its colour.
    let rim = smoothstep(draw.params.x - draw.params.y - 0.5, draw.params.x - draw.params.y + 0.5, away);
    return vec4<f32>(draw.color.rgb * (1.0 - 0.65 * rim * f32(draw.params.y > 0.0)), alpha);
}

struct Ends {
    a: vec4<f32>,
    b: vec4<f32>,
    visible: bool,
}

// Both ends in clip space, the part behind the near plane cut off.
fn clip_ends(a: vec3<f32>, b: vec3<f32>) -> Ends {
    var ends: Ends;
    ends.a = to_clip(from_eye(a));
    ends.b = to_clip(from_eye(b));
    let near = frame.viewport.w;
    let is_perspective = frame.light.w < 0.5;
    ends.visible = true;
    if is_perspective {
        let a_behind = ends.a.w < near;
        let b_behind = ends.b.w < near;
        ends.visible = !(a_behind && b_behind);
        if a_behind && !b_behind {
            ends.a = mix(ends.a, ends.b, (near - ends.a.w) / (ends.b.w - ends.a.w));
        } else if b_behind && !a_behind {
            ends.b = mix(ends.b, ends.a, (near - ends.b.w) / (ends.a.w - ends.b.w));
        }
    }
    return ends;
}

fn direction(from_pixel: vec2<f32>, to_pixel: vec2<f32>) -> vec2<f32> {
    let along = to_pixel - from_pixel;
    let length = length(along);
    if length < 1e-6 {
        return vec2<f32>(1.0, 0.0);
    }
    return along / length;
}

// params: half the width.
@vertex
fn line_vertex(
    @builtin(vertex_index) index: u32,
    @location(0) a: vec3<f32>,
    @location(1) b: vec3<f32>,
) -> Flat {
    var out: Flat;
    let ends = clip_ends(a, b);
    if !ends.visible {
        out.clip = nowhere();
        return out;
    }
    let a_pixel = to_pixels(ends.a);
    let b_pixel = to_pixels(ends.b);
    let along = direction(a_pixel, b_pixel);
    let corner = quad(index);
    // Ends reach half a width further, so that lines that meet at a vertex leave no notch.
    let shift = vec2<f32>(-along.y, along.x) * corner.y * draw.params.x
        + along * corner.x * draw.params.x * 0.5;
    if corner.x > 0.0 {
        out.clip = from_pixels(b_pixel + shift, ends.b);
    } else {
        out.clip = from_pixels(a_pixel + shift, ends.a);
    }
    out.clip = nearer(out.clip, draw.params.w);
    return out;
}

// params: half the width, distance from the edge, length of the head. Six corners of the shaft,
// three of the head.
@vertex
fn arrow_vertex(
    @builtin(vertex_index) index: u32,
    @location(0) a: vec3<f32>,
    @location(1) b: vec3<f32>,
    @location(2) inward: vec3<f32>,
) -> Flat {
    var out: Flat;
    let ends = clip_ends(a, b);
    if !ends.visible {
        out.clip = nowhere();
        return out;
    }
    let a_pixel = to_pixels(ends.a);
    let b_pixel = to_pixels(ends.b);
    let along = direction(a_pixel, b_pixel);
    let length = distance(a_pixel, b_pixel);
    // Which side of the edge its face is on, on the screen: where a point a little inward lands.
    let middle = (from_eye(a) + from_eye(b)) * 0.5;
    let step = inward * (0.05 * distance(from_eye(a), from_eye(b)));
    let inside = to_pixels(to_clip(middle + step)) - to_pixels(to_clip(middle));
    var across = vec2<f32>(-along.y, along.x);
    if dot(across, inside) < 0.0 {
        across = -across;
    }
    // On short edges everything shrinks, so that the arrow stays beside its edge.
    let scale = min(1.0, length / (draw.params.z * 3.0));
    let width = draw.params.x * max(scale, 0.4);
    let head = draw.params.z * scale;
    let base = across * draw.params.y * scale;
    let inset = min(length * 0.12, draw.params.z);
    let tail_pixel = a_pixel + along * inset + base;
    let tip_pixel = b_pixel - along * inset + base;
    let neck_pixel = tip_pixel - along * head;
    var pixel: vec2<f32>;
    var at_tip = true;
    if index < 6u {
        let corner = quad(index);
        at_tip = corner.x > 0.0;
        pixel = select(tail_pixel, neck_pixel, at_tip) + across * corner.y * width;
    } else if index == 6u {
        pixel = tip_pixel;
    } else {
        let side = select(-1.0, 1.0, index == 7u);
        pixel = neck_pixel + across * side * (head * 0.4 + width);
    }
    if at_tip {
        out.clip = from_pixels(pixel, ends.b);
    } else {
        out.clip = from_pixels(pixel, ends.a);
    }
    out.clip = nearer(out.clip, draw.params.w);
    return out;
}
