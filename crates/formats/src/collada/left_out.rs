//! Kinds of content that are not kept: counted and named.

use super::effect::OWN_PROFILE;
use super::xml::Document;
use crate::notes::Notes;
use crate::report::first_few;
use halfedge::words::counted;

/// Elements that stand for something left out, with what one and several are called.
const LEFT_OUT: [(&str, &str, &str); 12] = [
    ("animation", "animation", "animations"),
    ("camera", "camera", "cameras"),
    ("light", "light", "lights"),
    ("library_animation_clips", "library of animation clips", "libraries of animation clips"),
    ("library_physics_models", "library of physics models", "libraries of physics models"),
    ("library_physics_scenes", "library of physics scenes", "libraries of physics scenes"),
    ("library_force_fields", "library of force fields", "libraries of force fields"),
    ("library_kinematics_models", "library of kinematics models", "libraries of kinematics models"),
    ("library_kinematics_scenes", "library of kinematics scenes", "libraries of kinematics scenes"),
    ("library_articulated_systems", "library of articulated systems", "libraries of articulated systems"),
    ("library_joints", "library of joints", "libraries of joints"),
    ("library_formulas", "library of formulas", "libraries of formulas"),
];

/// Notes what the document holds besides meshes and materials.
pub(super) fn note(document: &Document, notes: &mut Notes) {
    let counts = LEFT_OUT.iter().filter_map(|(name, one, many)| {
        let count = document.all(name).count();
        (count > 0).then(|| counted(count, one, many))
    });
    let counts: Vec<String> = counts.collect();
    if !counts.is_empty() {
        notes.info(format!("Not kept: {}", counts.join(", ")));
    }
    let mut profiles: Vec<&str> = document
        .all("extra")
        .flat_map(|extra| document.children_named(extra, "technique"))
        .filter_map(|technique| technique.attribute("profile"))
        .filter(|&profile| profile != OWN_PROFILE)
        .collect();
    profiles.sort_unstable();
    profiles.dedup();
    if !profiles.is_empty() {
        notes.info(format!(
            "Extra data of other programs is kept only as far as it is about textures and double-sided faces: {}",
            first_few(&profiles, 8)
        ));
    }
}
