//! Pictures of all panes of the workshop, in all languages and three sizes, to be looked at: with `ANTIPODE_TEST_PICTURES=DIR` they
//! are written there. Where the picture of the room would be stands plain grey.

use antipode_language::{Language, Texts};
use antipode_render::{AdapterChoice, Gpu, Offscreen};
use antipode_ui::workshop::{FieldValue, WorkshopWish};

use super::*;
use crate::overlay::Overlay;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const SIZES: [(u32, u32); 3] = [(800, 600), (1280, 720), (1920, 1080)];

/// A window that is not there.
struct Shown<'a> {
    gpu: &'a Gpu,
    overlay: Overlay,
    size: (u32, u32),
}

impl Shown<'_> {
    /// One pass of the interface.
    fn pass(&mut self, game: &mut Game, events: Vec<egui::Event>) -> egui::FullOutput {
        let size = egui::vec2(self.size.0 as f32, self.size.1 as f32);
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            events,
            ..Default::default()
        };
        let drawn = Drawn::new(&DrawStats::default(), Quality::Fast);
        let context = self.overlay.context().clone();
        let output = context.run_pass(input, |context| {
            game.interface(context, Some((drawn, None)));
        });
        self.overlay.skip(&output.textures_delta);
        output
    }

    /// The middle of the first words on the screen that are these.
    fn place_of(&mut self, game: &mut Game, words: &str) -> egui::Pos2 {
        let output = self.pass(game, Vec::new());
        let found = output
            .shapes
            .iter()
            .find_map(|clipped| match &clipped.shape {
                egui::Shape::Text(text) if text.galley.text() == words => {
                    Some(text.galley.rect.translate(text.pos.to_vec2()).center())
                }
                _ => None,
            });
        found.unwrap_or_else(|| panic!("nothing says {words}"))
    }

    fn click(&mut self, game: &mut Game, words: &str) {
        let at = self.place_of(game, words);
        self.pass(game, vec![egui::Event::PointerMoved(at)]);
        for pressed in [true, false] {
            let event = egui::Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: egui::Modifiers::NONE,
            };
            self.pass(game, vec![event]);
        }
    }

    fn save(&mut self, game: &mut Game, file: &Path) {
        for _ in 0..3 {
            self.pass(game, Vec::new());
        }
        // What was sent to no adapter is sent to this one.
        self.overlay.move_to(self.gpu, FORMAT);
        let output = self.pass(game, Vec::new());
        let target = Offscreen::new(self.gpu, self.size.0, self.size.1, FORMAT);
        let mut encoder = self.gpu.encoder();
        clear(&mut encoder, target.view());
        self.overlay
            .paint(self.gpu, &mut encoder, &[target.view()], self.size, output);
        self.gpu.queue.submit([encoder.finish()]);
        target.read(self.gpu).unwrap().save(file).unwrap();
    }
}

fn clear(encoder: &mut wgpu::CommandEncoder, view: &wgpu::TextureView) {
    let grey = wgpu::Color {
        r: 0.3,
        g: 0.35,
        b: 0.4,
        a: 1.0,
    };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(grey),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    });
}

fn ask(game: &mut Game, wishes: impl IntoIterator<Item = WorkshopWish>) {
    for wish in wishes {
        game.follow_workshop(vec![wish]);
        game.tick(Instant::now());
    }
}

fn put(id: &str) -> WorkshopWish {
    WorkshopWish::Put(id.to_owned())
}

fn choose(name: &str) -> WorkshopWish {
    WorkshopWish::Choose {
        name: name.to_owned(),
        adds: false,
    }
}

#[test]
fn pictures_of_all_panes_are_written_where_somebody_asks_for_them() {
    let Some(dir) = std::env::var_os("ANTIPODE_TEST_PICTURES") else {
        return;
    };
    let dir = PathBuf::from(dir);
    fs::create_dir_all(&dir).unwrap();
    let opened = Gpu::headless(AdapterChoice::Auto);
    let opened = opened.map_err(|error| error.to_string());
    let Some(gpu) = antipode_testing::needed("a graphics adapter", opened.as_ref()) else {
        return;
    };
    for language in Language::ALL {
        for size in SIZES {
            let place = tempfile::tempdir().unwrap();
            let mut game = Game::new(worlds(&place.path().join("saves")), None, None);
            game.follow(Intent::BuildNewRoom);
            tick_until(&mut game, |game| game.play.phase.visit().is_some());
            game.play.room_drawn(&mut game.menus, false);
            game.menus.texts = Texts::new(language);
            let mut shown = Shown {
                gpu,
                overlay: Overlay::new(gpu, FORMAT),
                size,
            };
            let name = |what: &str| {
                let id = language.id();
                dir.join(format!("{id}-{}x{}-{what}.png", size.0, size.1))
            };
            shown.save(&mut game, &name("room"));
            ask(&mut game, [put("house"), WorkshopWish::Nudge([2, 0, 0])]);
            let say = |word: &str| Texts::new(language).say(word);
            ask(&mut game, [choose(&say("workshop-name-house-inside"))]);
            shown.save(&mut game, &name("lesson"));
            ask(&mut game, [WorkshopWish::EndLesson, put("tunnel")]);
            shown.save(&mut game, &name("tunnel"));
            let wide = WorkshopWish::Set {
                key: "size".to_owned(),
                value: FieldValue::Number(0, 3.0),
                done: true,
            };
            let portal = choose(&say("workshop-name-portal"));
            ask(&mut game, [put("portals"), portal, wide]);
            let began = Instant::now();
            while game.play.phase.visit().unwrap().messages() == 0 {
                assert!(began.elapsed() < Duration::from_mins(1));
                game.tick(Instant::now());
            }
            if size.0 < 1100 {
                shown.save(&mut game, &name("portal"));
                for pane in ["parts", "history"] {
                    shown.click(&mut game, &say(&format!("workshop-pane-{pane}")));
                    shown.save(&mut game, &name(pane));
                }
                let title = format!("{} ({})", say("workshop-pane-messages"), messages(&game));
                shown.click(&mut game, &title);
            }
            shown.save(&mut game, &name("messages"));
            for menu in ["edit", "view", "help"] {
                shown.click(&mut game, &say(&format!("workshop-menu-{menu}")));
                shown.save(&mut game, &name(menu));
                if menu != "help" {
                    let key = egui::Event::Key {
                        key: egui::Key::Escape,
                        physical_key: None,
                        pressed: true,
                        repeat: false,
                        modifiers: egui::Modifiers::NONE,
                    };
                    shown.pass(&mut game, vec![key]);
                    shown.pass(&mut game, Vec::new());
                }
            }
            shown.click(&mut game, &say("workshop-do-examples"));
            shown.save(&mut game, &name("examples"));
        }
    }
}

fn messages(game: &Game) -> usize {
    game.play.phase.visit().unwrap().messages()
}
