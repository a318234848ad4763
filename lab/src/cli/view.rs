//! The flags of the view of a scene, common to all commands that read one.

use super::job::Request;
use super::numbers;
use super::settings::SettingArguments;
use super::source::Source;

/// The camera, the pixels, and how to treat warnings.
#[derive(clap::Args, Debug)]
pub struct ViewArguments {
    /// Camera of a glTF file, by its name, its node's name, or its number [default: the first]
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,

    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = numbers::size)]
    pub size: Option<[u32; 2]>,

    /// Render only these pixels, counted from the top left; X1 and Y1 are excluded
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = numbers::crop)]
    pub crop: Option<[u32; 4]>,

    /// Treat warnings about the scene as errors
    #[arg(long)]
    pub strict: bool,
}

impl ViewArguments {
    /// The rendering of `scene`.
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
