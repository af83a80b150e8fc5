//! Pictures, pixel by pixel, on any adapter (in CI a software one).

mod support;

use glam::{DVec3, Vec2, Vec3, vec2, vec3};
use halfedge::edit::{Connect, delete_vertices, split_edge};
use halfedge::{Budget, EdgeId, Element, FaceId, Mesh, PolygonSoup, VertexId};
use support::gpu::{GAMMA, Gpu, Image, SIZE, VIEW, bare, close, draw, draw_with, frame, front, gpu, shown};
use support::{cube, grid, mesh, paint, paint_all, sphere};
use viewport::{Bounds, Camera, Frame, Highlight, Layer, Look, ObjectChange, Renderer, Shading, Style};

/// A square in the xy plane turned about the y axis, one colour.
fn tilted(degrees: f32, color: [u8; 3]) -> Mesh {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let corner = |x: f32, y: f32| vec3(x * cos, y, -x * sin);
    let mut square =
        mesh(vec![corner(-1., -1.), corner(1., -1.), corner(1., 1.), corner(-1., 1.)], &[[0, 1, 2, 3]]);
    paint(&mut square, 0, color);
    square
}

#[test]
fn a_lit_face_has_its_exact_colour_on_both_kinds_of_target() {
    let gpu = gpu();
    for color in [[255, 0, 0], [0x33, 0x66, 0xcc], [200, 200, 200]] {
        let square = tilted(0.0, color);
        let image = draw(&gpu, &square, &front(), &bare());
        assert!(close(image.at(100, 80), color, 1), "{:?}", image.at(100, 80));
        assert_eq!(image.at(2, 2), [0, 0, 0]);

        // A target that encodes colours shows the same bytes.
        let srgb = wgpu::TextureFormat::Rgba8UnormSrgb;
        let mut renderer = Renderer::new(&gpu.device, srgb);
        renderer.sync_object(&gpu.device, &gpu.queue, 7, &square, ObjectChange::Everything, &bare());
        let image = gpu.render(&mut renderer, &frame(&front(), &bare()), srgb);
        assert!(close(image.at(100, 80), color, 1), "{:?}", image.at(100, 80));
    }
}

#[test]
fn shading_is_lambert_over_a_floor_of_a_fifth() {
    let gpu = gpu();
    let camera = Camera { orthographic: true, ..front() };
    for (degrees, share) in [(0.0_f32, 1.0), (60.0, 0.6), (80.0, 0.2 + 0.8 * 80_f32.to_radians().cos())] {
        let image = draw(&gpu, &tilted(degrees, [250, 250, 250]), &camera, &bare());
        let expected = (250.0_f32 * share).round() as u8;
        assert!(close(image.at(100, 80), [expected; 3], 2), "{degrees}: {:?}", image.at(100, 80));
    }
    // The floor itself: a corner's normal that points away from the light on a face that doesn't.
    let roof = mesh(
        vec![
            vec3(-1., -2., 0.),
            vec3(1., -2., 0.),
            vec3(1., 2., 0.),
            vec3(-1., 2., 0.),
            vec3(-30., -2., -90.),
            vec3(-30., 2., -90.),
        ],
        &[vec![0, 1, 2, 3], vec![1, 4, 5, 2]],
    );
    let mut roof = roof;
    paint_all(&mut roof, [250; 3]);
    let image = draw(&gpu, &roof, &camera, &Style { shading: Shading::Smooth, ..bare() });
    let at = camera.project(vec3(0.9, 0.0, 0.0), VIEW).expect("in front");
    assert!(close(image.near(at), [50; 3], 3), "{:?}", image.near(at));
}

#[test]
fn the_studio_lights_every_side_of_a_cube_differently() {
    let gpu = gpu();
    let mut cube = cube();
    paint_all(&mut cube, [200; 3]);
    let style = Style { look: Look::Studio, ..bare() };
    // From the front corner above, and from the opposite one: the lights go with the camera.
    for yaw in [0.7, 0.7 + std::f64::consts::PI] {
        let mut camera = Camera { yaw, pitch: 0.5, distance: 6.0, ..Camera::default() };
        camera.set_scene(surface::measure::bounding_box(&cube));
        let image = draw(&gpu, &cube, &camera, &style);
        let side = |x: f32, y: f32, z: f32| {
            let turned = if yaw > 1.0 { vec3(-x, y, -z) } else { vec3(x, y, z) };
            image.near(camera.project(turned, VIEW).expect("in front"))[0]
        };
        let shades = [side(0.0, 1.0, 0.0), side(1.0, 0.0, 0.0), side(0.0, 0.0, 1.0)];
        let [top, right, left] = shades.map(i32::from);
        assert!(top > left + 20 && left > right + 20 && right > 70, "{shades:?}");
        assert!(top <= 200, "no side is brighter than its colour");
    }
}

#[test]
fn the_back_of_a_face_is_darker_and_tinted() {
    let gpu = gpu();
    let image = draw(&gpu, &tilted(180.0, [200, 100, 40]), &front(), &bare());
    let tint = bare().theme.back_face.0;
    let expected = std::array::from_fn(|i| {
        (f32::from([200_u8, 100, 40][i]) * 0.35 + f32::from(tint[i]) * 0.5).round() as u8
    });
    assert!(close(image.at(100, 80), expected, 2), "{:?} {expected:?}", image.at(100, 80));
}

#[test]
fn silhouettes_are_smoothed() {
    let gpu = gpu();
    let image =
        draw(&gpu, &tilted(0.0, [255; 3]), &Camera { yaw: 0.5, pitch: 0.3, ..Camera::default() }, &bare());
    let between = image.count(|p| p[0] > 10 && p[0] < 200 && !close(p, image.at(100, 80), 20));
    assert!(between > 50, "{between}");
}

#[test]
fn edges_are_drawn_and_inner_diagonals_are_not() {
    let gpu = gpu();
    let mut square = grid(2, 2, false);
    paint_all(&mut square, [255; 3]);
    let camera = front();
    let style = Style { wireframe: true, ..bare() };
    let image = draw(&gpu, &square, &camera, &style);
    let at = |p: Vec3| camera.project(p, VIEW).expect("in front");
    // The line may be between two pixels.
    let darkest = |p: Vec3| {
        let around = [vec2(0.0, 0.0), vec2(-1.0, -1.0), vec2(1.0, 1.0)];
        around.into_iter().map(|shift| image.near(at(p) + shift)[0]).min()
    };
    assert!(darkest(vec3(0.5, 0.0, 0.0)) < Some(140), "{:?}", darkest(vec3(0.5, 0.0, 0.0)));
    assert!(darkest(vec3(0.0, -0.4, 0.0)) < Some(140));
    assert!(image.near(at(vec3(0.5, 0.5, 0.0)))[0] > 240, "the middle of a diagonal");
    assert!(image.near(at(vec3(0.3, 0.3, 0.0)))[0] > 240);

    // Edges of a mesh too dense to tell them apart leave the shading alone.
    let mut dense = grid(300, 300, false);
    paint_all(&mut dense, [255; 3]);
    let image = draw(&gpu, &dense, &camera, &style);
    assert!(image.at(100, 80)[0] > 230, "{:?}", image.at(100, 80));
}

#[test]
fn a_concave_polygon_leaves_its_notch_open() {
    let gpu = gpu();
    let mut notched = mesh(
        vec![vec3(-1., -1., 0.), vec3(1., -1., 0.), vec3(1., 1., 0.), vec3(0., -0.6, 0.), vec3(-1., 1., 0.)],
        &[[0, 1, 2, 3, 4]],
    );
    paint(&mut notched, 0, [255, 0, 0]);
    let camera = front();
    let image = draw(&gpu, &notched, &camera, &bare());
    let at = |p: Vec3| camera.project(p, VIEW).expect("in front");
    assert_eq!(image.near(at(vec3(0.0, 0.3, 0.0))), [0, 0, 0]);
    for inside in [vec3(0.0, -0.8, 0.0), vec3(0.9, 0.5, 0.0), vec3(-0.9, 0.5, 0.0)] {
        assert!(image.near(at(inside))[0] > 200);
    }
}

#[test]
fn the_nearer_face_hides_the_farther() {
    let gpu = gpu();
    let mut cube = cube();
    for (face, color) in [[255, 0, 0], [0, 255, 0], [0, 0, 255]].into_iter().enumerate() {
        paint(&mut cube, face, color);
    }
    for orthographic in [false, true] {
        let camera = Camera { orthographic, ..front() };
        let image = draw(&gpu, &cube, &camera, &bare());
        assert!(close(image.at(100, 80), [255, 0, 0], 1));
        let behind = Camera { yaw: std::f64::consts::PI, ..camera };
        let image = draw(&gpu, &cube, &behind, &bare());
        assert!(close(image.at(100, 80), [0, 255, 0], 1));
    }
}

/// A picture of a mesh with highlights.
fn marked(
    gpu: &Gpu,
    mesh: &Mesh,
    camera: &Camera,
    style: &Style,
    marks: &[(Layer, Element, &[u32])],
) -> Image {
    draw_with(gpu, mesh, camera, style, |renderer| {
        for &(layer, kind, ids) in marks {
            let highlight = Highlight { object: 7, mesh, kind, ids };
            renderer.set_highlight(&gpu.device, &gpu.queue, layer, Some(highlight));
        }
    })
}

fn mix(a: [u8; 3], b: [u8; 3], share: f32) -> [u8; 3] {
    std::array::from_fn(|i| (f32::from(a[i]) * (1.0 - share) + f32::from(b[i]) * share).round() as u8)
}

#[test]
fn highlights_behind_faces_are_fainter() {
    let gpu = gpu();
    let (cube, style) = (cube(), bare());
    let selected = style.theme.selected.0;
    for orthographic in [false, true] {
        let camera = Camera { orthographic, yaw: 0.3, pitch: 0.3, ..front() };
        let at = |v: usize| camera.project(cube.position(VertexId::new(v)), VIEW).expect("in front");
        let edge = |a: usize, b: usize| {
            (
                cube.find_edge(VertexId::new(a), VertexId::new(b)).expect("an edge").raw(),
                (at(a) + at(b)) * 0.5,
            )
        };
        let plain = draw(&gpu, &cube, &camera, &style);
        // Vertex 0 is on the back, vertex 7 in front.
        for (v, strength) in [(0, 0.35), (7, 1.0)] {
            let image =
                marked(&gpu, &cube, &camera, &style, &[(Layer::Selected, Element::Vertex, &[v, 999])]);
            let expected = mix(plain.near(at(v as usize)), selected, strength);
            assert!(close(image.near(at(v as usize)), expected, 8), "{v}: {:?}", image.near(at(v as usize)));
        }
        for ((id, middle), strength) in [(edge(0, 1), 0.35), (edge(5, 7), 1.0)] {
            let image = marked(&gpu, &cube, &camera, &style, &[(Layer::Selected, Element::Edge, &[id])]);
            let expected = mix(plain.near(middle), selected, strength);
            assert!(close(image.near(middle), expected, 25), "{:?} {expected:?}", image.near(middle));
        }
        for (face, strength) in [(0_u32, 0.35), (1, 0.35 * 0.35)] {
            let middle: Vec2 =
                cube.face_vertices(FaceId::new(face as usize)).map(|v| at(v.index()) / 4.0).sum();
            let image = marked(&gpu, &cube, &camera, &style, &[(Layer::Selected, Element::Face, &[face])]);
            let expected = mix(plain.near(middle), selected, strength);
            assert!(close(image.near(middle), expected, 3), "{face}: {:?} {expected:?}", image.near(middle));
        }
    }
}

#[test]
fn all_of_a_highlight_on_a_surface_is_in_front() {
    let gpu = gpu();
    // Steep sides too, where the surface beside a line is much nearer or farther.
    let ball = sphere(16, 12);
    for orthographic in [false, true] {
        let camera = Camera { orthographic, distance: 4.0, ..Camera::default() };
        let style = bare();
        let (selected, plain) = (style.theme.selected.0, draw(&gpu, &ball, &camera, &style));
        let faces: Vec<u32> = (0..ball.face_capacity() as u32).collect();
        let image = marked(&gpu, &ball, &camera, &style, &[(Layer::Selected, Element::Face, &faces)]);
        let mut compared = 0;
        for (x, y) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
            let (before, after) = (plain.at(x, y), image.at(x, y));
            // Inside the ball, away from its outline.
            let away = vec2(x as f32 + 0.5, y as f32 + 0.5).distance(VIEW * 0.5);
            if away < 35.0 {
                // The back side's faint fill lies beneath the front side's.
                let expected = mix(mix(before, selected, 0.35 * 0.35), selected, 0.35);
                assert!(close(after, expected, 4), "{x} {y}: {before:?} {after:?} {expected:?}");
                compared += 1;
            }
        }
        assert!(compared > 3000);
    }
}

#[test]
fn hovering_hides_neither_the_selection_nor_a_faces_colour() {
    let gpu = gpu();
    let (mut square, camera, style) = (grid(2, 1, false), front(), bare());
    paint(&mut square, 0, [20, 200, 60]);
    let theme = style.theme;
    let at = |p: Vec3| camera.project(p, VIEW).expect("in front");
    let ids: [&[u32]; 1] = [&[0]];
    let look = |marks: &[(Layer, Element)], p: Vec2| {
        let marks: Vec<_> = marks.iter().map(|&(layer, kind)| (layer, kind, ids[0])).collect();
        marked(&gpu, &square, &camera, &style, &marks).near(p)
    };
    // A face: the hovered one keeps most of its colour, selected or not.
    let middle = at(vec3(-0.5, 0.0, 0.0));
    let plain = look(&[], middle);
    assert!(close(look(&[(Layer::Hovered, Element::Face)], middle), mix(plain, theme.hovered.0, 0.15), 2));
    let selected = mix(plain, theme.selected.0, 0.35);
    assert!(close(look(&[(Layer::Selected, Element::Face)], middle), selected, 2));
    let both = look(&[(Layer::Selected, Element::Face), (Layer::Hovered, Element::Face)], middle);
    assert!(close(both, mix(selected, theme.hovered.0, 0.15), 2));
    // Its outline is the hover's.
    let side = at(vec3(-1.0, 0.0, 0.0));
    let beside =
        look(&[(Layer::Selected, Element::Face), (Layer::Hovered, Element::Face)], side + vec2(2.0, 0.0));
    assert!(close(beside, theme.hovered.0, 90) && !close(selected, theme.hovered.0, 90), "{beside:?}");
    // A vertex: the selection's dot, the active one's core, and the hover's ring around them.
    let corner = square.position(VertexId::new(0));
    let all = [Layer::Selected, Layer::Active, Layer::Hovered].map(|layer| (layer, Element::Vertex));
    assert!(close(look(&all, at(corner)), theme.active.0, 3));
    assert!(close(look(&all[..1], at(corner)), theme.selected.0, 3));
    assert!(close(look(&all, at(corner) - vec2(5.5, 0.0)), theme.hovered.0, 40));
    assert!(close(look(&[all[2]], at(corner)), theme.hovered.0, 3));
}

#[test]
fn x_ray_shows_what_is_behind() {
    let gpu = gpu();
    let mut cube = cube();
    paint_all(&mut cube, [200; 3]);
    paint(&mut cube, 1, [250, 0, 0]);
    let solid = Style { wireframe: true, vertices: true, ..bare() };
    let x_ray = Style { x_ray: true, ..solid };
    let camera = Camera { yaw: 0.3, pitch: 0.3, ..front() };
    let at = |p: Vec3| camera.project(p, VIEW).expect("in front");
    let (before, after) = (draw(&gpu, &cube, &camera, &solid), draw(&gpu, &cube, &camera, &x_ray));
    // The red back through the grey front.
    let middle = at(vec3(0.2, 0.2, -1.0));
    let reddish = |image: &Image| i32::from(image.near(middle)[0]) - i32::from(image.near(middle)[1]);
    assert!(reddish(&before) == 0 && reddish(&after) > 8, "{} {}", reddish(&before), reddish(&after));
    // A hidden edge and the hidden vertex make a difference with x-ray only.
    let without_lines = Style { wireframe: false, vertices: false, ..solid };
    for hidden in [vec3(0.0, -1.0, -1.0), vec3(-1.0, -1.0, -1.0)] {
        let difference = |x_ray| {
            let [with, without] =
                [solid, without_lines].map(|style| draw(&gpu, &cube, &camera, &Style { x_ray, ..style }));
            let places = (-2..=2).flat_map(|x| (-2..=2).map(move |y| vec2(x as f32, y as f32)));
            places.map(|by| with.near(at(hidden) + by)[0].abs_diff(without.near(at(hidden) + by)[0])).max()
        };
        assert_eq!(difference(false), Some(0), "{hidden} is hidden");
        assert!(difference(true) > Some(15), "{hidden} shows: {:?}", difference(true));
    }
    // With one translucent face, the background shows in its known share.
    let square = tilted(0.0, [200; 3]);
    let image = draw(&gpu, &square, &front(), &Style { x_ray: true, ..bare() });
    assert!(close(image.at(100, 80), [100; 3], 2), "{:?}", image.at(100, 80));
}

#[test]
fn a_highlight_is_uploaded_some_elements_at_a_time() {
    let gpu = gpu();
    let ball = sphere(12, 8);
    let (camera, style) = (Camera::default(), bare());
    for kind in Element::ALL {
        let mut ids: Vec<u32> = (0..ball.capacity(kind) as u32).filter(|id| id % 5 != 0).collect();
        // A second time changes nothing.
        ids.extend(if kind == Element::Face { vec![1, 2] } else { vec![] });
        let highlight = Highlight { object: 7, mesh: &ball, kind, ids: &ids };
        let whole = draw_with(&gpu, &ball, &camera, &style, |renderer| {
            renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Selected, Some(highlight));
        });
        let mut parts = 0;
        let in_parts = draw_with(&gpu, &ball, &camera, &style, |renderer| {
            renderer.begin_highlight_upload(&gpu.device, Layer::Selected, Some(highlight));
            loop {
                parts += 1;
                if !renderer.upload_highlight_elements(
                    &gpu.device,
                    &gpu.queue,
                    Layer::Selected,
                    &ball,
                    &mut Budget::new(10),
                ) {
                    break;
                }
            }
            renderer.begin_highlight_upload(&gpu.device, Layer::Hovered, None);
        });
        assert!(parts > 5, "{kind}: {parts}");
        assert!(whole.pixels == in_parts.pixels, "{kind}");
        let plain = draw(&gpu, &ball, &camera, &style);
        assert!(plain.pixels != whole.pixels, "{kind} is highlighted");
    }
}

#[test]
fn a_half_edge_is_an_arrow_on_its_faces_side() {
    let gpu = gpu();
    let (square, camera, style) = (tilted(0.0, [255; 3]), front(), bare());
    let bottom = square.find_halfedge(VertexId::new(0), VertexId::new(1)).expect("a half-edge");
    for (h, up) in [(bottom, 1.0), (bottom.twin(), -1.0)] {
        let image = draw_with(&gpu, &square, &camera, &style, |renderer| {
            let highlight = Highlight { object: 7, mesh: &square, kind: Element::Halfedge, ids: &[h.raw()] };
            renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Selected, Some(highlight));
        });
        let edge = camera.project(vec3(0.0, -1.0, 0.0), VIEW).expect("in front");
        let is_marked = |p: Vec2| close(image.near(p), style.theme.selected.0, 3);
        assert!(is_marked(edge - vec2(0.0, 4.0 * up)), "inside");
        assert!(!is_marked(edge + vec2(0.0, 4.0 * up)), "outside");
        // The head, wider than the shaft, is at the end it points to.
        let wide = |x: f32| (1..12).filter(|&d| is_marked(edge + vec2(x, -up * d as f32))).count();
        let half = (camera.project(vec3(1.0, -1.0, 0.0), VIEW).expect("in front") - edge).x;
        let tip = if h == bottom { 1.0 } else { -1.0 } * (half - half * 0.24 - 6.0);
        assert!(wide(tip) > wide(-tip), "{} {}", wide(tip), wide(-tip));
    }
}

#[test]
fn the_ground_grid_lies_under_the_mesh_and_never_over_it() {
    let gpu = gpu();
    let mut cube = cube();
    paint_all(&mut cube, [250, 40, 40]);
    let tree = surface::FaceTree::new(&cube);
    for (pitch, orthographic) in [(0.5, false), (-0.4, false), (0.5, true), (1.2, true)] {
        let mut camera = Camera { yaw: 0.7, pitch, distance: 6.0, orthographic, ..Camera::default() };
        camera.set_scene(surface::measure::bounding_box(&cube));
        let without = draw(&gpu, &cube, &camera, &bare());
        let with = draw(&gpu, &cube, &camera, &Style { grid: true, ..bare() });
        let mut beside = 0;
        for (x, y) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
            if with.at(x, y) == without.at(x, y) {
                continue;
            }
            // Pixels on the silhouette may show part of it.
            let shows =
                [-1.0, 0.0, 1.0].iter().flat_map(|dx| [-1.0, 0.0, 1.0].map(|dy| vec2(*dx, dy))).any(|by| {
                    let ray = camera.ray(vec2(x as f32 + 0.5, y as f32 + 0.5) + by, VIEW);
                    tree.hit(&cube, ray).is_none()
                });
            assert!(shows, "{x}, {y} from pitch {pitch}: {:?} not {:?}", with.at(x, y), without.at(x, y));
            beside += usize::from(without.at(x, y) == [0, 0, 0]);
        }
        assert!(beside > 300, "{beside} pixels of grid beside the cube");
    }
    // The cube's lowest corner is on the ground: seen from the side, no line is above it.
    let mut camera = Camera { yaw: 0.0, pitch: 0.0, distance: 6.0, orthographic: true, ..Camera::default() };
    camera.set_scene(surface::measure::bounding_box(&cube));
    camera.pitch = 0.02;
    let with = draw(&gpu, &cube, &camera, &Style { grid: true, ..bare() });
    let without = draw(&gpu, &cube, &camera, &bare());
    let foot = camera.project(vec3(0.0, -1.0, 0.0), VIEW).expect("in front").y;
    let rows: Vec<u32> =
        (0..SIZE[1]).filter(|&y| (0..SIZE[0]).any(|x| with.at(x, y) != without.at(x, y))).collect();
    let reach = 12.0 * 6.0 * 0.02 * VIEW.y / 4.0;
    assert!(!rows.is_empty());
    assert!(rows.iter().all(|&y| (y as f32 - foot).abs() < reach), "{foot}: {rows:?}");
}

#[test]
fn dots_are_drawn_where_vertices_are_and_not_through_faces() {
    let gpu = gpu();
    let mut style = Style { vertices: true, ..bare() };
    style.theme.vertex = halfedge::Color([255, 0, 255]);
    let mut mesh = cube();
    paint_all(&mut mesh, [0, 255, 0]);
    let camera = front();
    let image = draw(&gpu, &mesh, &camera, &style);
    let at = |v: usize| camera.project(mesh.position(VertexId::new(v)), VIEW).expect("in front");
    assert!(close(image.near(at(4)), [255, 0, 255], 2), "{:?}", image.near(at(4)));
    assert!(!close(image.near(at(0)), [255, 0, 255], 60), "hidden by the front");
}

/// A square with isolated vertices in front of it, behind it and next to it.
fn square_with_isolated_vertices() -> Mesh {
    let corners = [vec3(-1., -1., 0.), vec3(1., -1., 0.), vec3(1., 1., 0.), vec3(-1., 1., 0.)];
    let strays = [vec3(0.0, 0.0, 0.5), vec3(0.5, 0.5, -0.5), vec3(1.4, 0.0, 0.0)];
    let soup = PolygonSoup::new([&corners[..], &strays].concat(), &[[0_u32, 1, 2, 3]]);
    let mut mesh = Mesh::build(soup).expect("a square").mesh;
    paint(&mut mesh, 0, [0, 255, 0]);
    mesh
}

#[test]
fn isolated_vertices_are_always_drawn() {
    let gpu = gpu();
    let mut style = bare();
    style.theme.vertex = halfedge::Color([0, 0, 255]);
    style.theme.isolated = halfedge::Color([255, 0, 255]);
    let (mesh, camera) = (square_with_isolated_vertices(), front());
    let is_dot = |image: &Image, v: usize, color: [u8; 3]| {
        let at = camera.project(mesh.position(VertexId::new(v)), VIEW).expect("in front");
        close(image.near(at), color, 2)
    };
    let dots =
        |image: &Image| -> Vec<usize> { (0..7).filter(|&v| is_dot(image, v, [255, 0, 255])).collect() };
    assert_eq!(dots(&draw(&gpu, &mesh, &camera, &style)), [4, 6], "hidden is the one behind the square");
    let all = draw(&gpu, &mesh, &camera, &Style { vertices: true, ..style });
    assert_eq!(dots(&all), [4, 6]);
    assert!((0..4).all(|v| is_dot(&all, v, [0, 0, 255])), "the others as ever");

    // So are those of an object that isn't active, whose other dots aren't drawn.
    let mut renderer = gpu.renderer();
    let style = Style { vertices: true, ..style };
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, ObjectChange::Everything, &style);
    let objects = [viewport::ObjectDraw { id: 7, visible: true, active: false }];
    let image = gpu.render(&mut renderer, &Frame { objects: &objects, ..frame(&camera, &style) }, GAMMA);
    assert_eq!(dots(&image), [4, 6]);
}

#[test]
fn isolated_vertices_follow_edits_and_undo() {
    let gpu = gpu();
    let (style, camera) = (bare(), front());
    let mut mesh = square_with_isolated_vertices();
    let mut renderer = gpu.renderer();
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, ObjectChange::Everything, &style);
    let mut pictures = vec![draw(&gpu, &mesh, &camera, &style)];
    let mut journals = Vec::new();
    for step in 0..3 {
        mesh.start_recording();
        match step {
            0 => mesh.set_position(VertexId::new(6), vec3(1.4, 0.5, 0.0)),
            1 => drop(delete_vertices(&mut mesh, &[VertexId::new(6)]).expect("no face needs it")),
            _ => drop(delete_vertices(&mut mesh, &[VertexId::new(4)]).expect("nor this one")),
        }
        let journal = mesh.finish_recording();
        let change = journal.touched();
        renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, ObjectChange::Touched(&change), &style);
        let followed = gpu.render(&mut renderer, &frame(&camera, &style), GAMMA);
        let anew = draw(&gpu, &mesh, &camera, &style);
        let differ = followed.pixels.iter().zip(&anew.pixels).filter(|(a, b)| a != b).count();
        assert!(differ < 8, "step {step}: {differ} pixels differ");
        assert!(followed.pixels != pictures[step].pixels, "step {step} is seen");
        pictures.push(followed);
        journals.push(journal);
    }
    for (journal, before) in journals.into_iter().zip(pictures).rev() {
        let change = mesh.undo(journal).touched();
        renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, ObjectChange::Touched(&change), &style);
        let undone = gpu.render(&mut renderer, &frame(&camera, &style), GAMMA);
        let differ = undone.pixels.iter().zip(&before.pixels).filter(|(a, b)| a != b).count();
        assert!(differ < 8, "{differ} pixels differ");
    }
}

#[test]
fn tiny_huge_and_far_models_look_like_others() {
    let gpu = gpu();
    let picture = |scale: f32, shift: Vec3| {
        let mut ball = sphere(24, 16);
        paint_all(&mut ball, [255, 0, 0]);
        let positions = ball.positions().iter().map(|p| *p * scale + shift).collect();
        ball.set_positions(positions).expect("as many");
        let mut camera = Camera::default();
        let bounds = surface::measure::bounding_box(&ball).expect("a box");
        camera.set_scene(Some(bounds));
        camera.reset(VIEW.x / VIEW.y);
        draw(&gpu, &ball, &camera, &Style { wireframe: true, ..bare() })
    };
    let usual = picture(1.0, Vec3::ZERO);
    for (scale, shift) in [
        (1e-4, Vec3::ZERO),
        (1e6, Vec3::ZERO),
        (1e-15, Vec3::ZERO),
        (1e15, Vec3::ZERO),
        (1e3, vec3(1e6, -1e6, 1e6)),
    ] {
        let image = picture(scale, shift);
        let differ = usual.pixels.iter().zip(&image.pixels).filter(|(a, b)| a[0].abs_diff(b[0]) > 24).count();
        assert!(differ < 60, "{scale} {shift}: {differ} pixels differ");
    }
}

#[test]
fn an_edited_object_looks_like_a_rebuilt_one() {
    let gpu = gpu();
    for shading in [Shading::Flat, Shading::Smooth] {
        let style = Style { shading, wireframe: true, vertices: true, ..bare() };
        let camera = Camera::default();
        let mut ball = sphere(12, 8);
        paint_all(&mut ball, [0, 200, 0]);
        let mut renderer = gpu.renderer();
        let whole = renderer.sync_object(&gpu.device, &gpu.queue, 7, &ball, ObjectChange::Everything, &style);
        ball.start_recording();
        for e in [3, 40, 41] {
            split_edge(&mut ball, EdgeId::new(e), 0.5, Connect::All).expect("splits");
        }
        ball.set_position(VertexId::new(20), ball.positions()[20] * 1.2);
        paint(&mut ball, 12, [255, 0, 0]);
        let touched = ball.finish_recording().touched();
        let change = ObjectChange::Touched(&touched);
        let part = renderer.sync_object(&gpu.device, &gpu.queue, 7, &ball, change, &style);
        assert!(part < whole / 2 + 4096, "{part} of {whole} bytes");
        let edited = gpu.render(&mut renderer, &frame(&camera, &style), GAMMA);
        let anew = draw(&gpu, &ball, &camera, &style);
        assert!(edited.count(|p| p[0] > 100 && p[1] < 80) > 5, "the painted face is in view");
        let differ = edited.pixels.iter().zip(&anew.pixels).filter(|(a, b)| a != b).count();
        assert!(differ < 8, "{differ} pixels differ");
    }
}

#[test]
fn an_object_is_drawn_as_it_was_until_the_upload_is_complete() {
    let gpu = gpu();
    let (style, camera) = (Style { vertices: true, ..bare() }, Camera::default());
    let (before, mut after) = (cube(), sphere(12, 8));
    paint_all(&mut after, [0, 200, 0]);
    let [old, new] = [&before, &after].map(|mesh| draw(&gpu, mesh, &camera, &style));
    let mut renderer = gpu.renderer();
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &before, ObjectChange::Everything, &style);
    let bytes = renderer.gpu_bytes();
    renderer.begin_object_upload(7, &after, &style);
    assert!(renderer.is_uploading(7));
    let (mut steps, mut most_bytes) = (0, 0);
    while renderer.is_uploading(7) {
        assert!(gpu.render(&mut renderer, &frame(&camera, &style), GAMMA).pixels == old.pixels, "{steps}");
        let done = renderer.upload_faces(&gpu.device, &gpu.queue, 7, &after, &mut Budget::new(25));
        assert_eq!(done, !renderer.is_uploading(7));
        steps += 1;
        most_bytes = most_bytes.max(renderer.gpu_bytes());
    }
    assert!(most_bytes > bytes, "the new buffers are beside the old ones");
    let least = after.face_count().div_ceil(25);
    assert!((least..2 * least).contains(&steps), "{steps}: triangles are counted before they are written");
    assert!(gpu.render(&mut renderer, &frame(&camera, &style), GAMMA).pixels == new.pixels);
    assert!(
        !renderer.upload_faces(&gpu.device, &gpu.queue, 7, &after, &mut Budget::new(25)),
        "there is no more to do"
    );

    // An edit during the upload is drawn with it.
    renderer.begin_object_upload(7, &after, &style);
    renderer.upload_faces(&gpu.device, &gpu.queue, 7, &after, &mut Budget::new(25));
    after.start_recording();
    for face in [2, 80] {
        paint(&mut after, face, [255, 0, 0]);
    }
    let touched = after.finish_recording().touched();
    let change = ObjectChange::Touched(&touched);
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &after, change, &style);
    assert!(renderer.is_uploading(7), "an edit doesn't complete the upload");
    while renderer.is_uploading(7) {
        renderer.upload_faces(&gpu.device, &gpu.queue, 7, &after, &mut Budget::new(25));
    }
    let painted = draw(&gpu, &after, &camera, &style);
    assert!(gpu.render(&mut renderer, &frame(&camera, &style), GAMMA).pixels == painted.pixels);
}

#[test]
fn more_than_a_page_of_triangles_is_drawn() {
    let gpu = gpu();
    let mut plane = grid(1100, 500, true);
    assert!(plane.face_count() > 1 << 20);
    let last = plane.face_capacity() - 1;
    for face in last - 2000..=last {
        paint(&mut plane, face, [255, 0, 0]);
    }
    let camera = Camera { distance: 3.0, ..front() };
    let image = draw(&gpu, &plane, &camera, &bare());
    let top = camera.project(vec3(0.0, 0.999, 0.0), VIEW).expect("in front");
    let red = (0..4).map(|d| image.near(top + vec2(20.0, d as f32))).any(|p| p[0] > p[1] + 30);
    assert!(red, "the last row is painted");
    assert!(close(image.at(100, 80), [200; 3], 2));
}

#[test]
fn a_frame_like_the_last_is_not_drawn_again() {
    let gpu = gpu();
    let (mesh, camera, style) = (cube(), Camera::default(), Style::default());
    let mut renderer = gpu.renderer();
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, ObjectChange::Everything, &style);
    let draws = |renderer: &mut Renderer, camera: &Camera| {
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let drew = renderer.prepare(0, &gpu.device, &gpu.queue, &mut encoder, &frame(camera, &style));
        gpu.queue.submit([encoder.finish()]);
        drew
    };
    assert!(draws(&mut renderer, &camera));
    assert!(!draws(&mut renderer, &camera));
    assert!(draws(&mut renderer, &Camera { yaw: 1.0, ..camera }));
    let ids = [0];
    let highlight = Highlight { object: 7, mesh: &mesh, kind: Element::Face, ids: &ids };
    renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Hovered, Some(highlight));
    assert!(draws(&mut renderer, &Camera { yaw: 1.0, ..camera }));
    renderer.remove_object(7);
    assert!(draws(&mut renderer, &Camera { yaw: 1.0, ..camera }));
}

#[test]
fn nothing_at_all_can_be_drawn() {
    let gpu = gpu();
    let mut renderer = gpu.renderer();
    let (camera, style) = (Camera::default(), Style { vertices: true, ..Style::default() });
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &Mesh::new(), ObjectChange::Everything, &style);
    let highlight = Highlight { object: 7, mesh: &Mesh::new(), kind: Element::Face, ids: &[0] };
    renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Selected, Some(highlight));
    let image = gpu.render(&mut renderer, &frame(&camera, &style), GAMMA);
    assert!(close(image.at(3, 1), style.theme.background_top.0, 3), "{:?}", image.at(3, 1));
    assert!(close(image.at(3, 158), style.theme.background_bottom.0, 3));
    let frame = Frame { size: [0, 0], objects: &[shown(9)], ..frame(&camera, &style) };
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    renderer.prepare(0, &gpu.device, &gpu.queue, &mut encoder, &frame);
    gpu.queue.submit([encoder.finish()]);
}

#[test]
fn picks_agree_with_the_picture() {
    let gpu = gpu();
    let mut ball = sphere(9, 7);
    let bits = |face: u32| -> [bool; 3] { std::array::from_fn(|i| (face % 7 + 1) >> i & 1 == 1) };
    for face in 0..ball.face_capacity() {
        paint(&mut ball, face, bits(face as u32).map(|on| if on { 255 } else { 0 }));
    }
    let tree = surface::FaceTree::new(&ball);
    let bounds = Bounds { min: Vec3::splat(-1.0), max: Vec3::ONE };
    let mut compared = 0;
    for i in 0..6_u32 {
        let mut camera = Camera {
            target: DVec3::new(f64::from(i) * 0.1, 0.05, 0.0),
            yaw: f64::from(i) * 1.3,
            pitch: f64::from(i) * 0.5 - 1.4,
            distance: 2.0 + f64::from(i),
            orthographic: i % 2 == 1,
            ..Camera::default()
        };
        camera.set_scene(Some(bounds));
        let image = draw(&gpu, &ball, &camera, &bare());
        for (x, y) in (1..SIZE[1] - 1).flat_map(|y| (1..SIZE[0] - 1).map(move |x| (x, y))) {
            let seen = |x: u32, y: u32| image.at(x, y).map(|c| c > 40);
            let here = seen(x, y);
            // At borders between faces pixels are mixed.
            let clear =
                [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)].iter().all(|&(x, y)| seen(x, y) == here);
            if clear && (x + y) % 3 == 0 {
                let pixel = vec2(x as f32 + 0.5, y as f32 + 0.5);
                let aim = viewport::Aim { kind: Element::Face, radius: 5.0, through: false };
                let picked = viewport::pick(&ball, &tree, &camera, VIEW, pixel, aim);
                assert_eq!(picked.map_or([false; 3], |p| bits(p.id)), here, "camera {i} at {x}, {y}");
                compared += 1;
            }
        }
    }
    assert!(compared > 20_000, "{compared}");
}
