//! The page on the host: panels and viewport driven through the accessibility tree, as a user or a screen
//! reader would, and pictures drawn by a software renderer.
#![cfg(not(target_arch = "wasm32"))]

mod access;
mod axes;
mod axis_widget;
mod bars;
mod bezier;
mod bridging;
mod camera;
mod contrast;
mod document;
mod editing;
mod embed;
mod held_keys;
mod hiding;
mod history;
mod keeping;
mod keyboard;
mod keys;
mod lists;
mod live;
mod live_bar;
mod looks;
mod menus;
mod motion;
mod mug;
mod narrow;
mod page;
mod previews;
mod properties;
mod regions;
mod ring_cut;
mod save;
mod screens;
mod selecting;
mod share;
mod shell;
mod slide;
mod split;
mod textures;
mod toasts;
mod viewport;
mod views;
mod welcome;
mod whole;
mod wording;
