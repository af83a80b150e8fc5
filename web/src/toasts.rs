//! Short messages over the viewport: what was imported, refused, or failed.

use editor::MessageKind;
use egui::{Align2, Area, Context, Frame, Id, Margin, Order, RichText, Role, Stroke, vec2};

use crate::actions::{self, Action};
use crate::app::App;
use crate::icons::{Icon, icon_button};
use crate::theme;

/// A message with what there is to say besides.
#[derive(Clone, Debug)]
struct Toast {
    kind: MessageKind,
    text: String,
    details: Vec<String>,
    open: bool,
    /// What can be done about it.
    remedy: Option<Action>,
    /// When it goes by itself, on egui's clock; none where the person has to close it.
    until: Option<f64>,
}

/// The messages that are in view.
#[derive(Debug, Default)]
pub struct Toasts {
    list: Vec<Toast>,
}

/// Seconds that a message stays which nothing has to be done about.
const BRIEFLY: f64 = 6.0;
/// Seconds that a refusal stays.
const LONGER: f64 = 12.0;
/// More than this would cover the viewport; the messages window has them all.
const MOST: usize = 4;

impl Toasts {
    fn add(&mut self, now: f64, kind: MessageKind, text: String, details: Vec<String>) {
        let stays = if kind == MessageKind::Info { BRIEFLY } else { LONGER };
        // The same again only stays longer.
        self.list.retain(|toast| toast.text != text);
        let until = Some(now + stays);
        self.list.push(Toast { kind, text, details, open: false, remedy: None, until });
        if self.list.len() > MOST {
            self.list.remove(0);
        }
    }

    /// Takes back what messages offer; what they say stays.
    pub(crate) fn withdraw(&mut self) {
        for toast in &mut self.list {
            toast.remedy = None;
        }
    }
}

impl App {
    /// Says something in passing, and in the messages window where the editor hasn't said it.
    pub(crate) fn toast(&mut self, kind: MessageKind, text: String, details: Vec<String>) {
        let now = self.ctx.input(|input| input.time);
        self.toasts.add(now, kind, text, details);
        self.ctx.request_repaint();
    }

    /// Offers an action in the message that was said last.
    pub(crate) fn offer(&mut self, remedy: Action) {
        if let Some(toast) = self.toasts.list.last_mut() {
            toast.remedy = Some(remedy);
        }
    }

    /// Says that something could not be done, in a toast and in the messages.
    pub(crate) fn fail(&mut self, text: String) {
        self.editor.say(MessageKind::Error, text.clone());
        self.toast(MessageKind::Error, text, Vec::new());
    }

    pub(crate) fn toasts(&mut self, ctx: &Context, narrow: bool) {
        let now = ctx.input(|input| input.time);
        self.toasts.list.retain(|toast| toast.until.is_none_or(|until| until > now));
        if self.toasts.list.is_empty() {
            return;
        }
        if let Some(next) = self.toasts.list.iter().filter_map(|toast| toast.until).reduce(f64::min) {
            ctx.request_repaint_after_secs((next - now).max(0.05) as f32);
        }
        let viewport = self.view.rect();
        let width = if narrow { viewport.width() - 24.0 } else { 360.0 };
        let mut closed = None;
        let mut chosen = None;
        Area::new(Id::unique("toasts"))
            .order(Order::Foreground)
            .pivot(Align2::LEFT_BOTTOM)
            .fixed_pos(viewport.left_bottom() + vec2(12.0, -12.0))
            .show(ctx, |ui| {
                ui.set_width(width);
                for (at, toast) in self.toasts.list.iter_mut().enumerate() {
                    let color = match toast.kind {
                        MessageKind::Info => theme::palette(ui.visuals()).good,
                        MessageKind::Warning => ui.visuals().warn_fg_color,
                        MessageKind::Error => ui.visuals().error_fg_color,
                    };
                    let frame = Frame::popup(ui.style())
                        .inner_margin(Margin { left: 14, right: 6, top: 6, bottom: 6 })
                        .show(ui, |ui| {
                            ui.set_width(width - 20.0);
                            ui.horizontal_top(|ui| {
                                ui.vertical(|ui| {
                                    ui.set_width(width - 58.0);
                                    ui.add_space(3.0);
                                    let text = ui.add(egui::Label::new(&toast.text).wrap());
                                    ui.ctx().accesskit_node_builder(text.id, |node| {
                                        node.set_role(Role::Alert);
                                        node.set_label(toast.text.as_str());
                                    });
                                    if let Some(entry) = toast.remedy.map(actions::describe)
                                        && ui.link(entry.label).on_hover_text(entry.description).clicked()
                                    {
                                        chosen = toast.remedy;
                                    }
                                    if toast.details.is_empty() {
                                        return;
                                    }
                                    let label = if toast.open { "Hide details" } else { "Details" };
                                    if ui
                                        .link(label)
                                        .on_hover_text("Shows everything there is to say")
                                        .clicked()
                                    {
                                        toast.open = !toast.open;
                                        // Somebody who reads decides when it goes.
                                        toast.until = None;
                                    }
                                    if toast.open {
                                        egui::ScrollArea::vertical().max_height(180.0).show(ui, |ui| {
                                            for line in &toast.details {
                                                ui.add(egui::Label::new(RichText::new(line).small()).wrap());
                                            }
                                        });
                                    }
                                });
                                if icon_button(ui, Icon::Close, "Dismiss message", false)
                                    .on_hover_text("Dismiss")
                                    .clicked()
                                {
                                    closed = Some(at);
                                }
                            });
                        });
                    let rect = frame.response.rect.shrink2(vec2(0.0, 5.0));
                    ui.painter().vline(rect.left() + 6.0, rect.y_range(), Stroke::new(3.0, color));
                }
            });
        if let Some(at) = closed {
            self.toasts.list.remove(at);
        }
        if let Some(action) = chosen {
            self.act(action);
        }
    }
}
