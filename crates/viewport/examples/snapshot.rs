//! Draws a few meshes in a few styles into a PNG: `cargo run -p viewport --example snapshot -- out.png`.

#[path = "../tests/support/mod.rs"]
mod support;

use halfedge::Element;
use support::gpu::{gpu, shown};
use support::{cube, paint, sphere};
use viewport::{Camera, Frame, Highlight, Layer, ObjectChange, Shading, Style, Theme};

const TILE: u32 = 360;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "snapshot.png".to_owned());
    let gpu = gpu();
    let mut ball = sphere(16, 12);
    paint(&mut ball, 40, [0xd0, 0x40, 0x40]);
    paint(&mut ball, 41, [0x40, 0x80, 0xd0]);
    let mut bowl = sphere(16, 12);
    let lid: Vec<_> =
        bowl.faces().filter(|&f| bowl.face_vertices(f).all(|v| bowl.position(v).y > 0.2)).collect();
    halfedge::edit::delete_faces(&mut bowl, &lid)?;
    let cube = cube();
    let light = Style { theme: Theme::LIGHT, ..Style::default() };
    let (smooth, dots) = (
        Style { shading: Shading::Smooth, wireframe: false, ..Style::default() },
        Style { vertices: true, ..light },
    );
    let tiles = [
        (&ball, Style::default(), Element::Vertex, vec![60, 61]),
        (&ball, smooth, Element::Face, vec![10, 11, 12, 20, 21, 22]),
        (&bowl, light, Element::Edge, vec![30, 31, 32]),
        (&cube, dots, Element::Halfedge, (0..24).collect()),
        (&cube, Style::default(), Element::Face, vec![0, 2]),
        (&bowl, smooth, Element::Vertex, (0..40).collect()),
    ];
    let columns = 3;
    let (width, height) = (TILE * columns, TILE * (tiles.len() as u32).div_ceil(columns));
    let mut picture = vec![0_u8; (width * height * 4) as usize];
    for (at, (mesh, style, kind, ids)) in tiles.iter().enumerate() {
        let mut renderer = gpu.renderer();
        renderer.sync_object(&gpu.device, &gpu.queue, 1, mesh, ObjectChange::Everything, style);
        let selected = Highlight { object: 1, mesh, kind: *kind, ids };
        renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Selected, Some(selected));
        let hovered = Highlight { ids: &ids[..1], ..selected };
        renderer.set_highlight(&gpu.device, &gpu.queue, Layer::Hovered, Some(hovered));
        let mut camera = Camera { orthographic: at == 4, ..Camera::default() };
        camera.set_scene(surface::measure::bounding_box(mesh));
        camera.reset(1.0);
        let frame =
            Frame { size: [TILE, TILE], pixels_per_point: 1.0, camera: &camera, objects: &[shown(1)], style };
        let image = gpu.render(&mut renderer, &frame, wgpu::TextureFormat::Rgba8Unorm);
        let (left, top) = (at as u32 % columns * TILE, at as u32 / columns * TILE);
        for (y, row) in image.pixels.chunks(TILE as usize).enumerate() {
            let start = (((top + y as u32) * width + left) * 4) as usize;
            picture[start..start + TILE as usize * 4].copy_from_slice(row.as_flattened());
        }
    }
    let mut encoder = png::Encoder::new(std::fs::File::create(&path)?, width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(&picture)?;
    println!("{path}");
    Ok(())
}
