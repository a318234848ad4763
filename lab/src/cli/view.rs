//! The flags of what is looked at in a scene, which every command that reads one takes.

use super::job::Request;
use super::numbers;
use super::settings::SettingArguments;
use super::source::Source;

/// Which pixels there are, and what is taken for wrong.
#[derive(clap::Args, Debug)]
pub struct ViewArguments {
    /// See a glTF file by the camera of this name, that of its node, or this number [default: the first]
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,

    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = numbers::size)]
    pub size: Option<[u32; 2]>,

    /// Only these pixels, counted from the top left; X1 and Y1 are excluded
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = numbers::crop)]
    pub crop: Option<[u32; 4]>,

    /// Take every warning about the scene as an error
    #[arg(long)]
    pub strict: bool,
}

impl ViewArguments {
    /// What is to be rendered of `scene`.
    pub fn request<'a>(
        &'a self,
        scene: &'a Source,
        settings: &SettingArguments,
        spp: u32,
        seed: u32,
    ) -> Request<'a> {
        Request {
            scene,
            settings: settings.settings(),
            auto: settings.auto(),
            camera: self.camera.as_deref(),
            size: self.size,
            crop: self.crop,
            spp,
            seed,
            strict: self.strict,
            quiet: false,
        }
    }
}
