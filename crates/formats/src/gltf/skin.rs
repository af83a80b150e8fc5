//! Skins: vertices placed by joints in the pose of the scene. The transform of the skinned node itself is
//! ignored (glTF 2.0, 3.7.3.3).

use super::accessor;
use super::buffers::Buffers;
use super::json::{Document, NODES, SKINS};
use super::rows::Rows;
use super::scene::Scene;
use crate::soup::placement::Influences;
use glam::DMat4;

/// The transforms of the joints of a skin, from the bind pose to the world.
///
/// # Errors
/// When the skin can't be read or a joint can't be placed.
pub(super) fn joints(
    document: &Document,
    buffers: &Buffers,
    scene: &Scene,
    skin: usize,
) -> Result<Vec<DMat4>, String> {
    let skin = document.item(SKINS, skin)?;
    let inverse_binds = skin.index("inverseBindMatrices")?;
    let inverse_binds = inverse_binds.map(|index| accessor::rows(document, buffers, index)).transpose()?;
    let list = skin.list("joints");
    if list.is_empty() {
        return Err("it has no joints".to_owned());
    }
    let joint = |(i, joint): (usize, _)| {
        let node = super::json::whole(joint).ok_or("its joints are no whole numbers")?;
        let world = scene.worlds.get(node).copied().flatten();
        let world =
            world.ok_or_else(|| format!("its joint {} can't be placed", document.label(NODES, node)))?;
        let inverse_bind = inverse_binds.as_ref().filter(|rows| rows.width == 16 && i < rows.count);
        let inverse_bind = inverse_bind.map_or(DMat4::IDENTITY, |rows| DMat4::from_cols_array(&rows.row(i)));
        let whole = world * inverse_bind;
        let place = || format!("its joint {} has no finite transform", document.label(NODES, node));
        if whole.is_finite() { Ok(whole) } else { Err(place()) }
    };
    list.iter().enumerate().map(joint).collect()
}

/// The joints that move each of `count` vertices, from the rows of joints and weights. A vertex without
/// weights follows its first joint.
pub(super) fn influences(sets: &[(Rows, Rows)], count: usize) -> Influences {
    let mut influences = Influences { starts: vec![0], list: Vec::new() };
    for vertex in 0..count {
        let start = influences.list.len();
        for (joints, weights) in sets {
            let pairs = joints.row::<4>(vertex).into_iter().zip(weights.row::<4>(vertex));
            let pairs = pairs.filter(|(_, weight)| weight.is_finite() && *weight > 0.0);
            influences.list.extend(pairs.map(|(joint, weight)| (joint as u32, weight as f32)));
        }
        if influences.list.len() == start
            && let Some((joints, _)) = sets.first()
        {
            influences.list.push((joints.index(vertex), 1.0));
        }
        influences.starts.push(influences.list.len() as u32);
    }
    influences
}
