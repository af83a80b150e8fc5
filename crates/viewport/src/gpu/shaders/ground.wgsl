// What is behind the objects: the background gradient and the grid of the ground plane.

struct Background {
    @builtin(position) clip: vec4<f32>,
    @location(0) height: f32,
}

@vertex
fn background_vertex(@builtin(vertex_index) index: u32) -> Background {
    let place = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    var out: Background;
    out.clip = vec4<f32>(place * 2.0 - 1.0, 0.0, 1.0);
    out.height = place.y;
    return out;
}

@fragment
fn background_fragment(in: Background) -> @location(0) vec4<f32> {
    return mix(frame.background_bottom, frame.background_top, in.height);
}

struct Ground {
    @builtin(position) clip: vec4<f32>,
    // From the middle of the grid, in fine spacings.
    @location(0) place: vec2<f32>,
    // From the point below the target, in units of the reach.
    @location(1) from_target: vec2<f32>,
}

@vertex
fn ground_vertex(@builtin(vertex_index) index: u32) -> Ground {
    let right = index == 1u || index == 2u || index == 4u;
    let top = index == 2u || index == 4u || index == 5u;
    let corner = vec2<f32>(select(-1.0, 1.0, right), select(-1.0, 1.0, top)) * frame.grid_fade.x;
    let place = corner + frame.grid_fade.zw;
    var out: Ground;
    out.clip = to_clip(frame.grid.xyz + to_scene(vec3<f32>(place.x, 0.0, place.y)));
    out.place = place / frame.grid.w;
    out.from_target = corner / frame.grid_fade.x;
    return out;
}

// How much of the pixel is on a line, for lines this many fine spacings apart.
fn on_line(place: vec2<f32>, slope: vec2<f32>, every: f32) -> f32 {
    let p = place / every;
    let per_pixel = max(slope / every, vec2<f32>(1e-6));
    let away = abs(p - round(p)) / per_pixel;
    let line = 1.0 - smoothstep(vec2<f32>(0.3), vec2<f32>(1.2), away);
    // Where lines crowd into a few pixels they would flicker.
    let room = 1.0 - smoothstep(vec2<f32>(0.1), vec2<f32>(0.4), per_pixel);
    return max(line.x * room.x, line.y * room.y);
}

@fragment
fn ground_fragment(in: Ground) -> @location(0) vec4<f32> {
    let slope = fwidth(in.place);
    let fine = on_line(in.place, slope, 1.0) * 0.35 * (1.0 - frame.grid_fade.y);
    let middle = on_line(in.place, slope, 10.0) * mix(0.7, 0.35, frame.grid_fade.y);
    let coarse = on_line(in.place, slope, 100.0) * 0.7;
    let fade = 1.0 - smoothstep(0.15, 1.0, length(in.from_target));
    let alpha = max(fine, max(middle, coarse)) * fade * frame.grid_color.a;
    return vec4<f32>(frame.grid_color.rgb, alpha);
}
