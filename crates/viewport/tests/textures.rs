//! Textures, pixel by pixel.

mod support;

use glam::{Affine2, Vec2, Vec3, vec2, vec3};
use halfedge::attribute::Column;
use halfedge::{Color, Element, FaceId, Mesh, NONE, keys};
use support::gpu::{Gpu, Image, SIZE, VIEW, bare, close, frame, front, gpu};
use support::{grid, mesh, paint_all};
use viewport::{
    Camera, ColorBy, Look, MaterialLook, Materials, ObjectChange, Picture, Renderer, Style, Texture, Wrap,
};

const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const WHITE: [u8; 3] = [255; 3];

fn style() -> Style {
    Style { look: Look::Texture, ..bare() }
}

fn flat() -> Camera {
    Camera { orthographic: true, ..front() }
}

fn picture(size: [u32; 2], pixels: &[[u8; 3]]) -> Picture {
    let pixels = pixels.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]).collect();
    let made = formats::Picture::new(size, pixels);
    Picture { size: made.size, pixels: made.pixels }
}

/// Red and green above, blue and white below.
fn four() -> Picture {
    let quarter = |i: usize| [[RED, GREEN], [BLUE, WHITE]][i / 16 / 8][i % 16 / 8];
    picture([16, 16], &(0..256).map(quarter).collect::<Vec<_>>())
}

/// Gives the corners texture coordinates by their places, and all faces a material.
fn textured(mut mesh: Mesh, uv: impl Fn(Vec3) -> Vec2, material: &str) -> Mesh {
    for h in mesh.halfedges().collect::<Vec<_>>() {
        let at = mesh.position(mesh.from(h));
        mesh.set(keys::CORNER_UV, h.index(), uv(at));
    }
    let labels = vec![0; mesh.face_capacity()];
    mesh.insert_column(
        Element::Face,
        Column { labels: vec![material.to_owned()], ..Column::with_values(keys::FACE_MATERIAL, labels) },
    );
    mesh
}

/// The square from -1 to 1 in the xy plane, which the picture covers.
fn square() -> Mesh {
    textured(grid(1, 1, false), over_square, "m")
}

fn over_square(at: Vec3) -> Vec2 {
    at.truncate() * 0.5 + 0.5
}

fn look(texture: Option<Texture>, color: Option<[u8; 3]>) -> Materials {
    Materials::new([MaterialLook { name: "m".to_owned(), color: color.map(Color), texture }])
}

fn clamped(number: u64) -> Texture {
    Texture { wrap: [Wrap::Clamp; 2], ..Texture::new(number) }
}

/// A renderer with the picture of number 1 and these materials.
fn renderer(gpu: &Gpu, materials: Materials, shown: Picture) -> Renderer {
    let mut renderer = gpu.renderer();
    renderer.set_materials(materials);
    renderer.set_picture(&gpu.device, 1, shown);
    // One row at a time.
    while renderer.upload_pictures(&gpu.queue, 1) {}
    renderer
}

fn draw(gpu: &Gpu, renderer: &mut Renderer, mesh: &Mesh, camera: &Camera, style: &Style) -> Image {
    renderer.sync_object(&gpu.device, &gpu.queue, 7, mesh, ObjectChange::Everything, style);
    gpu.render(renderer, &frame(camera, style), support::gpu::GAMMA)
}

fn drawn(mesh: &Mesh, materials: Materials, shown: Picture, style: &Style) -> Image {
    let gpu = gpu();
    let mut renderer = renderer(&gpu, materials, shown);
    draw(&gpu, &mut renderer, mesh, &flat(), style)
}

fn at(image: &Image, x: f32, y: f32) -> [u8; 3] {
    image.near(flat().project(vec3(x, y, 0.0), VIEW).expect("in front"))
}

/// The share of a picture's colour that a face towards the camera shows.
const LIGHT: f32 = 0.896;

/// A picture's colour in that light.
fn lit(color: [u8; 3]) -> [u8; 3] {
    color.map(|c| (f32::from(c) * LIGHT).round() as u8)
}

/// Checks colours at places of the square.
fn assert_shows(image: &Image, expected: &[(f32, f32, [u8; 3])], what: &str) {
    for &(x, y, color) in expected {
        let found = at(image, x, y);
        assert!(close(found, lit(color), 3), "{what}: {found:?} at {x} {y}, not {:?}", lit(color));
    }
}

#[test]
fn a_picture_is_upright_and_not_mirrored() {
    let image = drawn(&square(), look(Some(clamped(1)), None), four(), &style());
    let corners = [(-0.9, 0.9, RED), (0.9, 0.9, GREEN), (-0.9, -0.9, BLUE), (0.9, -0.9, WHITE)];
    assert_shows(&image, &corners, "four");
    assert_eq!(image.at(2, 2), [0, 0, 0], "the background");
}

#[test]
fn polygons_that_are_not_convex_show_it_where_it_lies() {
    // An arrow to the right, whose tail is notched.
    let corners = vec![vec3(-0.9, 0.9, 0.), vec3(-0.3, 0., 0.), vec3(-0.9, -0.9, 0.), vec3(0.9, 0., 0.)];
    let arrow = textured(mesh(corners, &[[0, 1, 2, 3]]), over_square, "m");
    let stripes: Vec<[u8; 3]> = (0..16).map(|i| [i * 16, 0, 255 - i * 16]).collect();
    let image = drawn(&arrow, look(Some(clamped(1)), None), picture([16, 1], &stripes), &style());
    let of_row = |x: f32| {
        let (t, [a, b]) = ((x * 0.5 + 0.5) * 16.0 - 0.5, [0, 1]);
        let mix = |c: usize| {
            let [low, high] = [a, b].map(|i| linear(stripes[(t.floor() as usize + i).min(15)][c]));
            srgb(low + (high - low) * t.fract())
        };
        [mix(0), mix(1), mix(2)]
    };
    let expected = [(0.5, 0.05), (-0.2, 0.1), (-0.5, 0.5), (-0.5, -0.5), (0.1, -0.3)];
    assert_shows(&image, &expected.map(|(x, y)| (x, y, of_row(x))), "arrow");
    assert_eq!(at(&image, -0.7, 0.0), [0, 0, 0], "the notch");
}

fn linear(c: u8) -> f32 {
    let c = f32::from(c) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

fn srgb(light: f32) -> u8 {
    let c = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (c * 255.0).round() as u8
}

#[test]
fn beyond_its_edges_a_picture_repeats_or_not_and_transforms_move_it() {
    // From -1 to 2 in u and v: three pictures side by side, two across each.
    let wide = textured(grid(1, 1, false), |at| at.truncate() * 1.5 + 0.5, "m");
    let shows = |texture: Texture| drawn(&wide, look(Some(texture), None), four(), &style());
    // The middles of the pixels of the picture on the left and above the one in the middle.
    let left = (-1.0 + 0.25 / 1.5, 0.5 / 3.0);
    let above = (-0.5 / 3.0, 1.0 - 0.25 / 1.5);
    let cases = [(Wrap::Repeat, RED, RED), (Wrap::Mirror, GREEN, BLUE), (Wrap::Clamp, RED, RED)];
    for (wrap, on_left, on_top) in cases {
        let image = shows(Texture { wrap: [wrap; 2], ..Texture::new(1) });
        let expected = [(left.0, left.1, on_left), (above.0, above.1, on_top)];
        assert_shows(&image, &expected, &format!("{wrap:?}"));
    }
    // A quarter turn to the left about the top left corner of the picture, and back into it.
    let turn = Affine2::from_mat2_translation(glam::mat2(vec2(0.0, 1.0), vec2(-1.0, 0.0)), vec2(1.0, 0.0));
    let turned = Texture { transform: turn, ..clamped(1) };
    let image = drawn(&square(), look(Some(turned), None), four(), &style());
    // u' = 1 - v and v' = u: what was at the top right is at the top left.
    let corners = [(-0.9, 0.9, GREEN), (0.9, 0.9, WHITE), (-0.9, -0.9, RED), (0.9, -0.9, BLUE)];
    assert_shows(&image, &corners, "turned");
}

#[test]
fn the_material_or_the_paint_colours_a_picture_in_linear_light() {
    let grey = || picture([1, 1], &[[188; 3]]);
    let middle =
        |mesh: &Mesh, color| at(&drawn(mesh, look(Some(Texture::new(1)), color), grey(), &style()), 0.3, 0.2);
    let product = |[r, g, b]: [u8; 3]| lit([r, g, b].map(|c| srgb(linear(188) * linear(c))));
    assert!(close(middle(&square(), None), lit([188; 3]), 2), "no colour");
    let mut of_material = square();
    paint_all(&mut of_material, [255, 128, 0]);
    assert!(close(middle(&of_material, Some([255, 128, 0])), product([255, 128, 0]), 2));
    assert!(close(middle(&of_material, None), product([255, 128, 0]), 2), "painted");
    let mut black = square();
    paint_all(&mut black, [0; 3]);
    assert!(close(middle(&black, Some([0; 3])), lit([188; 3]), 2), "black stands for no colour");
}

#[test]
fn twenty_textures_and_faces_without_one() {
    let gpu = gpu();
    let mut strips = textured(grid(24, 1, false), over_square, "m0");
    let labels: Vec<u32> = (0..24).map(|i| if i < 22 { i } else { NONE }).collect();
    strips.insert_column(
        Element::Face,
        Column {
            labels: (0..22).map(|i| format!("m{i}")).collect(),
            ..Column::with_values(keys::FACE_MATERIAL, labels)
        },
    );
    // The last but one has a material whose picture is still to come, the last two have none.
    let color = |i: u32| [(i * 11) as u8, 255 - (i * 11) as u8, (i % 3 * 100) as u8];
    let looks = (0..22_u32).map(|i| MaterialLook {
        name: format!("m{i}"),
        color: None,
        texture: Some(Texture::new(u64::from(i))),
    });
    let mut renderer = gpu.renderer();
    renderer.set_materials(Materials::new(looks));
    for i in 0..21 {
        renderer.set_picture(&gpu.device, u64::from(i), picture([1, 1], &[color(i)]));
    }
    assert!(!renderer.upload_pictures(&gpu.queue, usize::MAX));
    for x_ray in [false, true] {
        let style = Style { x_ray, ..style() };
        let image = draw(&gpu, &mut renderer, &strips, &flat(), &style);
        let shown = |i: u32| at(&image, (i as f32 + 0.5) / 12.0 - 1.0, 0.3);
        let over = |color: [u8; 3]| if x_ray { color.map(|c| c / 2) } else { color };
        for i in 0..21 {
            let expected = over(lit(color(i)));
            assert!(close(shown(i), expected, 3), "{i}: {:?}, not {expected:?}", shown(i));
        }
        assert!(close(shown(21), over(lit(WHITE)), 3), "no picture yet: {:?}", shown(21));
        let plain = bare();
        let grey = draw(&gpu, &mut renderer, &strips, &flat(), &Style { x_ray, look: Look::Studio, ..plain });
        assert_eq!(shown(23), at(&grey, 23.5 / 12.0 - 1.0, 0.3), "as in the studio's light");
    }
    renderer.retain_pictures(|number| number != 3);
    assert!(renderer.has_picture(4) && !renderer.has_picture(3));
    let image = draw(&gpu, &mut renderer, &strips, &flat(), &style());
    assert!(close(at(&image, 3.5 / 12.0 - 1.0, 0.3), lit(WHITE), 3), "without its picture");
}

#[test]
fn edits_and_their_undo_show() {
    let gpu = gpu();
    let mut plane = textured(grid(2, 2, false), over_square, "m");
    let mut renderer = renderer(&gpu, look(Some(clamped(1)), None), four());
    let before = draw(&gpu, &mut renderer, &plane, &flat(), &style());
    plane.start_recording();
    // The face at the lower left shows what the one at the upper right does.
    let corners: Vec<_> = plane.face_halfedges(FaceId::new(0)).collect();
    for h in corners {
        let uv = plane.get(keys::CORNER_UV, h.index());
        plane.set(keys::CORNER_UV, h.index(), uv + 0.5);
    }
    let journal = plane.finish_recording();
    let mut sync = |plane: &Mesh, touched: &halfedge::Touched| {
        let change = ObjectChange::Touched(touched);
        renderer.sync_object(&gpu.device, &gpu.queue, 7, plane, change, &style());
        gpu.render(&mut renderer, &frame(&flat(), &style()), support::gpu::GAMMA)
    };
    let edited = sync(&plane, &journal.touched());
    assert_shows(&edited, &[(-0.1, -0.1, GREEN), (-0.9, 0.9, RED)], "edited");
    let back = plane.undo(journal);
    assert!(sync(&plane, &back.touched()).pixels == before.pixels, "undone");
}

#[test]
fn far_away_a_picture_has_the_mean_of_its_light() {
    let pixels: Vec<[u8; 3]> = (0..64 * 64).map(|i| [((i + i / 64) % 2) as u8 * 255; 3]).collect();
    let many = textured(grid(1, 1, false), |at| at.truncate() * 40.0, "m");
    let image = drawn(&many, look(Some(Texture::new(1)), None), picture([64, 64], &pixels), &style());
    let inside: Vec<[u8; 3]> = (70..130).map(|x| image.at(x, 80)).collect();
    assert!(inside.iter().all(|pixel| close(*pixel, lit([188; 3]), 8)), "{inside:?}");
}

#[test]
fn where_alpha_is_low_nothing_is_drawn() {
    let gpu = gpu();
    let cut = Texture { cutoff: 0.5, ..clamped(1) };
    let left_clear = vec![255, 0, 0, 0, 0, 255, 0, 255];
    let mut renderer = gpu.renderer();
    for (texture, expected) in [(cut, [0; 3]), (clamped(1), lit(RED))] {
        renderer.set_materials(look(Some(texture), None));
        let made = formats::Picture::new([2, 1], left_clear.clone());
        renderer.set_picture(&gpu.device, 1, Picture { size: made.size, pixels: made.pixels });
        renderer.upload_pictures(&gpu.queue, usize::MAX);
        let image = draw(&gpu, &mut renderer, &square(), &flat(), &style());
        assert!(close(at(&image, -0.8, 0.0), expected, 3), "{:?}", at(&image, -0.8, 0.0));
        assert!(close(at(&image, 0.8, 0.0), lit(GREEN), 3));
    }
}

#[test]
fn what_lies_behind_translucent_faces_shows_through() {
    let gpu = gpu();
    let mut renderer = gpu.renderer();
    // A square half as opaque as usual in front of another one, without texture coordinates.
    let mut squares = mesh(
        [1.0, -1.0]
            .iter()
            .flat_map(|z| [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| vec3(x, y, *z)))
            .collect(),
        &[vec![0, 1, 2, 3], vec![4, 5, 6, 7]],
    );
    let mut labels = vec![0; squares.face_capacity()];
    labels[1] = 1;
    squares.insert_column(
        Element::Face,
        Column {
            labels: vec!["glass".to_owned(), "wall".to_owned()],
            ..Column::with_values(keys::FACE_MATERIAL, labels)
        },
    );
    squares.set(keys::FACE_COLOR, 0, Color(RED));
    squares.set(keys::FACE_COLOR, 1, Color(GREEN));
    let look = |name: &str, color, texture| MaterialLook {
        name: name.to_owned(),
        color: Some(Color(color)),
        texture,
    };
    let materials = |opacity: f32| {
        let glass = (opacity < 1.0).then(|| Texture::plain(opacity));
        Materials::new([look("glass", RED, glass), look("wall", GREEN, None)])
    };
    for (opacity, cull) in [(1.0, false), (0.25, false), (0.25, true)] {
        renderer.set_materials(materials(opacity));
        let shown = draw(&gpu, &mut renderer, &squares, &flat(), &Style { cull, ..style() });
        let [r, g, b] = at(&shown, 0.3, 0.2);
        let [red, green] = [lit(RED)[0], studio_green()].map(f32::from);
        let expected = if opacity < 1.0 {
            [red * opacity, green * (1.0 - opacity)]
        } else {
            [studio_green().into(), 0.0]
        };
        let close = |found: u8, expected: f32| (f32::from(found) - expected).abs() < 6.0;
        assert!(
            close(r, expected[0]) && close(g, expected[1]) && b < 6,
            "{opacity}: {r} {g} {b}, not {expected:?}"
        );
    }
    // In the checker's look, which needs texture coordinates, they are as they were.
    let checker = Style { look: Look::Checker, ..style() };
    renderer.set_materials(materials(1.0));
    let before = draw(&gpu, &mut renderer, &squares, &flat(), &checker);
    assert!(at(&before, 0.3, 0.2)[0] > 150);
}

/// The green of a green face towards the camera in the studio's light.
fn studio_green() -> u8 {
    let mut green = grid(1, 1, false);
    paint_all(&mut green, GREEN);
    at(&drawn(&green, Materials::default(), four(), &Style { look: Look::Studio, ..bare() }), 0.3, 0.2)[1]
}

#[test]
fn colours_that_stand_for_something_take_the_place_of_pictures() {
    let gpu = gpu();
    let mut renderer = renderer(&gpu, look(Some(clamped(1)), None), four());
    let shown = |renderer: &mut Renderer, look, color_by| {
        draw(&gpu, renderer, &square(), &flat(), &Style { look, color_by, ..style() })
    };
    for by in [ColorBy::Valence, ColorBy::Material, ColorBy::Uniform] {
        let [textured, plain] = [Look::Texture, Look::Studio].map(|look| shown(&mut renderer, look, by));
        assert!(textured.pixels == plain.pixels, "{by:?}");
    }
}

#[test]
fn uploads_follow_the_look_and_the_materials() {
    let gpu = gpu();
    let mut renderer = renderer(&gpu, look(None, None), four());
    let plain = Style { look: Look::Studio, ..style() };
    draw(&gpu, &mut renderer, &square(), &flat(), &plain);
    let bytes = renderer.gpu_bytes();
    assert!(!renderer.fits_style(7, &style()) && renderer.fits_style(7, &plain));
    draw(&gpu, &mut renderer, &square(), &flat(), &style());
    assert!(renderer.fits_style(7, &style()) && renderer.gpu_bytes() > bytes);
    renderer.set_materials(look(None, None));
    assert!(renderer.fits_style(7, &style()), "the same materials");
    renderer.set_materials(look(Some(clamped(1)), None));
    assert!(!renderer.fits_style(7, &style()), "a picture has come");
    assert_shows(&draw(&gpu, &mut renderer, &square(), &flat(), &style()), &[(-0.9, 0.9, RED)], "then");
}

#[test]
fn the_checker_needs_no_picture_and_shows_which_way_is_up() {
    let style = Style { look: Look::Checker, ..style() };
    let image = drawn(&square(), look(None, None), four(), &style);
    // Neighbouring cells differ in light; to the right they are redder, to the top greener.
    let cell = |i: u32, j: u32| at(&image, (i as f32 + 0.5) / 4.0 - 1.0, (j as f32 + 0.5) / 4.0 - 1.0);
    let sum = |[r, g, b]: [u8; 3]| u32::from(r) + u32::from(g) + u32::from(b);
    assert!(sum(cell(3, 3)).abs_diff(sum(cell(4, 3))) > 60 && sum(cell(3, 3)).abs_diff(sum(cell(3, 4))) > 60);
    assert!(cell(7, 3)[0] > cell(1, 3)[0] + 25 && cell(3, 7)[1] > cell(3, 1)[1] + 25);
    let bare = grid(1, 1, false);
    let [without, studio] = [style, Style { look: Look::Studio, ..style }]
        .map(|style| drawn(&bare, Materials::default(), four(), &style));
    assert!(without.pixels == studio.pixels, "without texture coordinates");
    assert_eq!(SIZE, without.size);
}
