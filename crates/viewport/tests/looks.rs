//! The looks, pixel by pixel.

mod support;

use glam::{Vec2, Vec3, vec2, vec3};
use halfedge::{FaceId, Mesh};
use support::gpu::{SIZE, VIEW, bare, close, draw, front, gpu};
use support::{cube, grid, paint_all, sphere};
use viewport::{Camera, Look, Matcap, Shading, Style};

const GREY: [u8; 3] = halfedge::Color::UNPAINTED.0;

fn with(look: Look) -> Style {
    Style { look, ..bare() }
}

/// The grid of one square, facing the camera after a turn about the y axis.
fn turned(degrees: f32) -> Mesh {
    let mut square = grid(1, 1, false);
    let (sin, cos) = degrees.to_radians().sin_cos();
    let turn = |p: &Vec3| vec3(p.x * cos, p.y, -p.x * sin);
    let positions = square.positions().iter().map(turn).collect();
    square.set_positions(positions).expect("as many");
    square
}

#[test]
fn a_matcap_shows_the_colour_of_its_sphere_for_each_normal() {
    let gpu = gpu();
    let camera = Camera { orthographic: true, ..front() };
    for look in Look::ALL {
        let Some(matcap) = look.matcap() else { continue };
        for degrees in [-70.0_f32, -30.0, 0.0, 45.0, 75.0] {
            let image = draw(&gpu, &turned(degrees), &camera, &with(look));
            let (sin, cos) = degrees.to_radians().sin_cos();
            let expected = matcap.color(vec3(sin, 0.0, cos));
            assert!(close(image.at(100, 80), expected, 6), "{look:?} at {degrees}: {:?}", image.at(100, 80));
        }
        // A painted face has the matcap in its colour.
        let mut green = turned(0.0);
        paint_all(&mut green, [0, 200, 0]);
        let [r, g, b] = draw(&gpu, &green, &camera, &with(look)).at(100, 80);
        assert!(r == 0 && g > 60 && b == 0, "{look:?}: {r} {g} {b}");
    }
}

#[test]
fn matcaps_are_lit_from_above_and_differ() {
    let shades = [Matcap::Clay, Matcap::Pearl, Matcap::Metal, Matcap::RedWax];
    for (i, matcap) in shades.into_iter().enumerate() {
        let sum = |n: Vec3| matcap.color(n.normalize()).iter().map(|c| i32::from(*c)).sum::<i32>();
        assert!(sum(vec3(-0.4, 0.6, 0.7)) > sum(vec3(0.4, -0.6, 0.7)) + 60, "{matcap:?}");
        for other in &shades[..i] {
            assert!(!close(matcap.color(Vec3::Z), other.color(Vec3::Z), 20), "{matcap:?} {other:?}");
        }
    }
}

#[test]
fn flat_shows_colours_and_normals_their_directions() {
    let gpu = gpu();
    let camera = Camera { yaw: 0.7, pitch: 0.5, ..front() };
    let image = draw(&gpu, &cube(), &camera, &with(Look::Flat));
    let other = image.count(|p| p != [0, 0, 0] && !close(p, GREY, 0));
    assert!(other < 700, "but for the silhouette all is one grey: {other}");

    let image = draw(&gpu, &cube(), &camera, &with(Look::Normals));
    let at = |p: Vec3| image.near(camera.project(p, VIEW).expect("in front"));
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        let expected = (axis * 0.5 + 0.5).to_array().map(|c| (c * 255.0).round() as u8);
        assert!(close(at(axis), expected, 2), "{axis}: {:?}", at(axis));
    }
}

#[test]
fn orientation_tells_fronts_from_backs_and_culling_leaves_backs_out() {
    let gpu = gpu();
    for (degrees, is_front) in [(0.0, true), (180.0, false)] {
        let square = turned(degrees);
        let [r, _, b] = draw(&gpu, &square, &front(), &with(Look::Orientation)).at(100, 80);
        assert_eq!((b > r.saturating_add(80), r > b.saturating_add(80)), (is_front, !is_front), "{degrees}");
        for look in Look::ALL {
            let culled = Style { cull: true, ..with(look) };
            let image = draw(&gpu, &square, &front(), &culled);
            let drawn = draw(&gpu, &square, &front(), &with(look));
            if is_front {
                assert!(image.pixels == drawn.pixels, "{look:?}");
            } else {
                assert_eq!(image.at(100, 80), [0, 0, 0], "{look:?}");
            }
        }
    }
}

#[test]
fn backs_differ_from_fronts_and_from_both_backgrounds() {
    let gpu = gpu();
    let (back, face) = (turned(180.0), turned(0.0));
    for look in [Look::Studio, Look::Course, Look::Flat, Look::Matcap(Matcap::Clay)] {
        let [of_back, of_front] =
            [&back, &face].map(|mesh| draw(&gpu, mesh, &front(), &with(look)).at(100, 80));
        let light = |[r, g, b]: [u8; 3]| 0.3 * f32::from(r) + 0.6 * f32::from(g) + 0.1 * f32::from(b);
        assert!(light(of_front) > light(of_back) + 25.0, "{look:?}: {of_front:?} {of_back:?}");
        for theme in [viewport::Theme::DARK, viewport::Theme::LIGHT] {
            for background in [theme.background_top.0, theme.background_bottom.0] {
                let apart = (light(of_back) - light(background)).abs();
                assert!(apart > 30.0, "{look:?}: {of_back:?} on {background:?}");
            }
        }
    }
}

#[test]
fn hidden_lines_are_edges_on_the_background_of_every_object() {
    let gpu = gpu();
    let style = Style { grid: false, shadow: false, ..Style { look: Look::HiddenLine, ..Style::default() } };
    let camera = front();
    let image = draw(&gpu, &cube(), &camera, &style);
    let empty = draw(&gpu, &Mesh::new(), &camera, &style);
    assert!(close(image.at(100, 80), empty.at(100, 80), 2), "a face is like the background");
    let corner = camera.project(vec3(1.0, 0.0, 1.0), VIEW).expect("in front");
    let brightest = (-2..=2).map(|x| image.near(corner + vec2(x as f32, 0.0))[0]).max();
    assert!(brightest > Some(120), "the front edge is bright: {brightest:?}");
    // The back edges are hidden.
    let back = camera.project(vec3(0.0, 1.0, -1.0), VIEW).expect("in front");
    let hidden = (-2..=2).all(|y| {
        let at = back + vec2(0.0, y as f32);
        close(image.near(at), empty.near(at), 2)
    });
    assert!(hidden);
}

#[test]
fn zebra_stripes_are_black_and_white_and_bend_with_the_surface() {
    let gpu = gpu();
    let style = Style { shading: Shading::Smooth, ..with(Look::Zebra) };
    let image = draw(&gpu, &sphere(96, 64), &front(), &style);
    let column: Vec<bool> = (30..130).map(|y| image.at(100, y)[0] > 120).collect();
    let changes = column.windows(2).filter(|w| w[0] != w[1]).count();
    assert!((4..40).contains(&changes), "{changes} changes in the middle column");
    // A plane seen in parallel mirrors one direction.
    let camera = Camera { orthographic: true, ..front() };
    let image = draw(&gpu, &turned(20.0), &camera, &style);
    assert_eq!(image.at(90, 60), image.at(110, 100));
}

#[test]
fn a_soft_shadow_lies_on_the_ground_beside_the_model_and_never_over_it() {
    let gpu = gpu();
    let cube = cube();
    let tree = surface::FaceTree::new(&cube);
    let mut white = bare();
    white.theme = viewport::Theme::LIGHT;
    for (pitch, orthographic) in [(0.5, false), (0.5, true), (1.2, false), (-0.3, false)] {
        let mut camera = Camera { yaw: 0.7, pitch, distance: 6.0, orthographic, ..Camera::default() };
        camera.set_scene(surface::measure::bounding_box(&cube));
        let without = draw(&gpu, &cube, &camera, &white);
        let with = draw(&gpu, &cube, &camera, &Style { shadow: true, ..white });
        let mut darker = 0;
        for (x, y) in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
            let [before, after] = [without.at(x, y), with.at(x, y)];
            if before == after {
                continue;
            }
            assert!((0..3).all(|i| after[i] <= before[i]), "{x}, {y}: {after:?} is lighter than {before:?}");
            let at = vec2(x as f32 + 0.5, y as f32 + 0.5);
            let around = [-1.0, 0.0, 1.0].map(|dx| [-1.0, 0.0, 1.0].map(|dy| at + vec2(dx, dy)));
            let shows = around.as_flattened().iter().any(|p| tree.hit(&cube, camera.ray(*p, VIEW)).is_none());
            assert!(shows, "{x}, {y} from pitch {pitch} is on the cube");
            darker += usize::from(after[0] + 8 < before[0]);
        }
        assert_eq!(darker > 100, pitch > 0.0, "{darker} darker pixels from pitch {pitch}");
        // Far from the model there is none.
        let far = camera.project(vec3(2.4, -1.0, 2.4), VIEW).filter(|p| inside(*p));
        if let Some(far) = far {
            assert_eq!(with.near(far), without.near(far));
        }
    }
}

fn inside(p: Vec2) -> bool {
    p.cmpge(Vec2::ZERO).all() && p.cmplt(VIEW).all()
}

#[test]
fn the_shadow_follows_edits() {
    let gpu = gpu();
    let mut camera = Camera { yaw: 0.7, pitch: 0.6, distance: 9.0, ..Camera::default() };
    let mut mesh = cube();
    camera.set_scene(surface::measure::bounding_box(&mesh));
    let mut style = Style { shadow: true, ..bare() };
    style.theme = viewport::Theme::LIGHT;
    let mut renderer = gpu.renderer();
    let change = viewport::ObjectChange::Everything;
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, change, &style);
    let frame = |camera| support::gpu::frame(camera, &style);
    gpu.render(&mut renderer, &frame(&camera), support::gpu::GAMMA);
    mesh.start_recording();
    halfedge::edit::delete_faces(&mut mesh, &[FaceId::new(5), FaceId::new(0)]).expect("faces");
    let touched = mesh.finish_recording().touched();
    let change = viewport::ObjectChange::Touched(&touched);
    renderer.sync_object(&gpu.device, &gpu.queue, 7, &mesh, change, &style);
    let followed = gpu.render(&mut renderer, &frame(&camera), support::gpu::GAMMA);
    let anew = draw(&gpu, &mesh, &camera, &style);
    let differ = followed.pixels.iter().zip(&anew.pixels).filter(|(a, b)| a != b).count();
    assert!(differ < 8, "{differ} pixels differ");
}

#[test]
fn marks_are_drawn_on_the_faces_that_show_and_hidden_by_others() {
    let gpu = gpu();
    let mut cube = cube();
    paint_all(&mut cube, [200; 3]);
    let style = Style { marks: viewport::Marks::default().toggled(viewport::Mark::Sharp), ..bare() };
    let camera = Camera { yaw: 0.5, pitch: 0.4, ..front() };
    let image = support::gpu::draw_with(&gpu, &cube, &camera, &style, |renderer| {
        assert_eq!(renderer.mark_count(7, viewport::Mark::Sharp), 0);
        let mut parts = 1;
        while renderer.upload_marks(&gpu.device, &gpu.queue, 7, &cube, &style, &mut halfedge::Budget::new(5))
        {
            parts += 1;
        }
        assert!(parts > 2, "{parts}");
        assert_eq!(renderer.mark_count(7, viewport::Mark::Sharp), 12);
    });
    let blue = viewport::Theme::mark(viewport::Mark::Sharp).0;
    let at = |p: Vec3| camera.project(p, VIEW).expect("in front");
    let is_marked = |p: Vec3| {
        let around = (-1..=1).flat_map(|x| (-1..=1).map(move |y| vec2(x as f32, y as f32)));
        around.map(|by| image.near(at(p) + by)).any(|color| close(color, blue, 40))
    };
    assert!(is_marked(vec3(1.0, 0.0, 1.0)), "the edge towards the eye");
    assert!(!is_marked(vec3(-1.0, 0.0, -1.0)), "the edge on the far side");
    let plain = draw(&gpu, &cube, &camera, &bare());
    assert!(image.count(|p| close(p, blue, 40)) > 100 && plain.count(|p| close(p, blue, 40)) == 0);
}
