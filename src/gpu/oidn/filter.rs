//! One filter: pictures in, a picture out.

use std::ffi::{CStr, c_int};
use std::ptr::NonNull;

use super::api::RawFilter;
use super::{OidnError, OwnDevice};

/// Three floats a pixel, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    pub width: usize,
    pub height: usize,
    pub values: Vec<[f32; 3]>,
}

/// The role of a picture in the filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    Colour,
    Albedo,
    Normal,
}

impl Input {
    fn name(self) -> &'static CStr {
        match self {
            Self::Colour => c"color",
            Self::Albedo => c"albedo",
            Self::Normal => c"normal",
        }
    }
}

/// A filter of its device, which outlives it.
pub struct Filter<'a> {
    device: &'a OwnDevice,
    filter: NonNull<RawFilter>,
}

/// `OIDN_FORMAT_FLOAT3`.
const FLOAT3: c_int = 3;

impl<'a> Filter<'a> {
    pub fn new(device: &'a OwnDevice) -> Result<Self, OidnError> {
        // SAFETY: the device is alive.
        let filter = unsafe { (device.api.new_filter)(device.raw(), c"RT".as_ptr()) };
        match NonNull::new(filter) {
            Some(filter) => Ok(Self { device, filter }),
            None => {
                device.check()?;
                Err(OidnError::Failed("no filter".to_owned()))
            }
        }
    }

    /// Filters the first of `inputs`, which are all of one size.
    pub fn run(self, inputs: &[(Input, &Pixels)]) -> Result<Pixels, OidnError> {
        let (_, first) = inputs[0];
        let pixels = first.width * first.height;
        let mut out = Pixels {
            values: vec![[0.0; 3]; pixels],
            ..*first
        };
        for (_, input) in inputs {
            let size = (input.width, input.height, input.values.len());
            assert_eq!(size, (out.width, out.height, pixels), "inputs of one size");
        }
        for (input, picture) in inputs {
            // The library only reads its inputs.
            self.set_image(input.name(), picture.values.as_ptr().cast_mut(), &out);
        }
        let values = out.values.as_mut_ptr();
        self.set_image(c"output", values, &out);
        let (api, raw) = (&self.device.api, self.filter.as_ptr());
        let colour = inputs[0].0 == Input::Colour;
        // SAFETY: the filter is alive; so are the pictures, of the size that `set_image` was given, and nothing else
        // touches `out` before the call returns.
        unsafe {
            if colour {
                (api.set_filter_bool)(raw, c"hdr".as_ptr(), true);
                (api.set_filter_bool)(raw, c"cleanAux".as_ptr(), inputs.len() > 1);
            }
            (api.commit_filter)(raw);
            (api.execute_filter)(raw);
        }
        self.device.check()?;
        Ok(out)
    }

    /// Lends pixels to the filter until it has run.
    fn set_image(&self, name: &CStr, values: *mut [f32; 3], size: &Pixels) {
        let (api, raw) = (&self.device.api, self.filter.as_ptr());
        // SAFETY: the pixels are contiguous: width · height of three floats, which `run` has made sure of.
        unsafe {
            (api.set_image)(
                raw,
                name.as_ptr(),
                values.cast(),
                FLOAT3,
                size.width,
                size.height,
                0,
                0,
                0,
            );
        }
    }
}

impl Drop for Filter<'_> {
    fn drop(&mut self) {
        // SAFETY: the filter is alive, and no one else has it.
        unsafe { (self.device.api.release_filter)(self.filter.as_ptr()) }
    }
}
