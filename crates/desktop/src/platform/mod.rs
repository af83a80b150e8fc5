//! The editor's [`Platform`] on a desktop: jobs run in a thread, files come from and go to the disk, documents and settings
//! are kept in the user's folders.

mod files;
mod folder_disk;
mod inbox;
mod jobs;
mod places;
mod settings;
mod store;

use std::collections::HashMap;
use std::path::PathBuf;
use std::time::{Instant, SystemTime, UNIX_EPOCH};

use directories::ProjectDirs;
use editor::JobRequest;
use egui::ViewportCommand;
use formats::Format;
use meshwright_web::platform::store::{Id, Request};
use meshwright_web::platform::{DeviceInfo, Download, Event, NamedBytes, PlacedFile, Platform, Source};

use files::Files;
use inbox::Inbox;
use jobs::Jobs;
use settings::Settings;
use store::Store;

/// The desktop as a platform.
pub struct Desktop {
    ctx: egui::Context,
    inbox: Inbox,
    jobs: Jobs,
    store: Store,
    settings: Settings,
    files: Files,
    /// The settings of this window.
    window_settings: HashMap<String, String>,
    wanted: Vec<PathBuf>,
    device: DeviceInfo,
    started: Instant,
}

impl Desktop {
    /// A desktop that opens these files at the start.
    pub fn new(ctx: &egui::Context, wanted: Vec<PathBuf>, device: DeviceInfo) -> Self {
        let inbox = Inbox::new(ctx);
        let folders = ProjectDirs::from("", "", "Meshwright");
        let documents = folders.as_ref().map(|folders| folders.data_local_dir().to_owned());
        Self {
            ctx: ctx.clone(),
            jobs: Jobs::new(inbox.clone()),
            store: Store::new(documents, inbox.clone()),
            settings: Settings::load(folders.map(|folders| folders.config_dir().join("settings.json"))),
            files: Files::new(inbox.clone()),
            window_settings: HashMap::new(),
            wanted,
            inbox,
            device,
            started: Instant::now(),
        }
    }
}

impl Platform for Desktop {
    fn poll(&mut self, ctx: &egui::Context) -> Vec<Event> {
        let dropped = ctx.input(|input| input.raw.dropped_files.clone());
        if !dropped.is_empty() {
            let paths = dropped.iter().map(|file| file.path().to_owned()).collect();
            self.files.open(paths);
        }
        self.inbox.take()
    }

    fn start_job(&mut self, job: u64, request: &JobRequest) {
        self.jobs.start(job, request.clone());
    }

    fn wanted(&self) -> Vec<String> {
        self.wanted.iter().map(|path| path.display().to_string()).collect()
    }

    fn parameter(&self, _name: &str) -> Option<String> {
        None
    }

    fn address(&self) -> Option<String> {
        None
    }

    fn fragment(&self) -> String {
        String::new()
    }

    fn clear_fragment(&mut self) {}

    /// Reads the files that the program was given. Only those are asked for, so the addresses are their names.
    fn fetch(&mut self, job: u64, _addresses: Vec<String>) {
        self.files.fetch(job, self.wanted.clone());
    }

    fn cancel_job(&mut self, job: u64) {
        self.jobs.cancel(job);
    }

    fn open_file_dialog(&mut self) {
        self.files.ask_what_to_open();
    }

    fn download(&mut self, files: Vec<NamedBytes>) -> Download {
        self.files.ask_where_to_save(files);
        Download::Asking
    }

    fn can_write(&self, source: Source, _name: &str) -> bool {
        // Companion files go beside the model.
        self.files.is_known(source)
    }

    fn ask_to_write(&mut self, _source: Source) {}

    fn write_back(&mut self, source: Source, files: Vec<NamedBytes>) {
        self.files.write_back(source, files);
    }

    fn remember_file(&mut self, document: &Id, file: Option<&PlacedFile>) {
        let file = file.and_then(|file| Some((self.files.path(file.source)?, file.format.code())));
        let file = file.as_ref().map(|(path, format)| (path.as_path(), *format));
        places::remember(&mut self.settings, document, file);
    }

    fn recall_file(&mut self, document: &Id) {
        let Some((path, format)) = places::recall(&self.settings, document) else { return };
        let Some(name) = path.file_name().map(|name| name.to_string_lossy().into_owned()) else { return };
        let source = self.files.number(path);
        if let Some(file) = PlacedFile::new(source, &name, Format::from_code(&format)) {
            self.inbox.push(Event::Recalled { document: document.clone(), file });
        }
    }

    fn update(&mut self) {}

    fn load_setting(&self, key: &str) -> Option<String> {
        self.settings.get(key)
    }

    fn store_setting(&mut self, key: &str, value: &str) {
        self.settings.set(key, value);
    }

    fn load_tab_setting(&self, key: &str) -> Option<String> {
        self.window_settings.get(key).cloned()
    }

    fn store_tab_setting(&mut self, key: &str, value: &str) {
        self.window_settings.insert(key.to_owned(), value.to_owned());
    }

    fn set_title(&mut self, title: &str) {
        self.ctx.send_viewport_cmd(ViewportCommand::Title(title.to_owned()));
    }

    fn ask_store(&mut self, request: &Request, bytes: &[u8]) {
        self.store.ask(request.clone(), bytes.to_vec());
    }

    fn new_id(&mut self) -> Id {
        store::new_id()
    }

    fn persist(&mut self) {}

    fn date_ms(&self) -> f64 {
        SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |since| since.as_secs_f64() * 1000.0)
    }

    fn reduces_motion(&self) -> bool {
        false
    }

    fn draw_on(&mut self, ctx: &egui::Context, device: DeviceInfo) {
        (self.ctx, self.device) = (ctx.clone(), device);
    }

    fn device(&self) -> DeviceInfo {
        self.device.clone()
    }

    fn now(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }
}
