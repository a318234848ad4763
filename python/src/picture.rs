//! A picture, for Python.

use std::path::PathBuf;

use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use vkpt::film::{Channel, Film};
use vkpt::image::Format;
use vkpt::report;
use vkpt_cli::Rendered;
use vkpt_lab::cli::exit::Failure;
use vkpt_lab::compare::command::Comparand;

use crate::arrays::{array, film, read_only};
use crate::failure::raise;

/// A picture, its layers, and how it was rendered.
#[pyclass(frozen, module = "vkpt")]
pub struct Picture {
    #[pyo3(get)]
    rgb: Py<PyArray3<f32>>,
    #[pyo3(get)]
    stderr: Option<Py<PyArray3<f32>>>,
    #[pyo3(get)]
    denoised: Option<Py<PyArray3<f32>>>,
    #[pyo3(get)]
    layers: Py<PyDict>,
    /// All but the films, whose pixels are in the arrays.
    rest: Rendered,
    /// More samples follow.
    grows: bool,
}

/// The estimated error of a picture at one time.
#[pyclass(frozen, get_all, module = "vkpt")]
#[derive(Clone)]
pub struct ErrorAt {
    spp: u32,
    seconds: f64,
    rel_mse: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
}

impl Picture {
    pub fn new(py: Python, mut of: Rendered) -> PyResult<Self> {
        let empty = Film {
            width: of.film.width,
            height: of.film.height,
            rgb: Vec::new(),
        };
        let optional = |film: Option<Film>| {
            film.map(|film| array(py, film).map(Bound::unbind))
                .transpose()
        };
        Ok(Self {
            stderr: optional(of.stderr.take())?,
            denoised: optional(of.denoised.take())?,
            layers: layers(py, &of.channels, [of.film.width, of.film.height])?.unbind(),
            rgb: array(py, std::mem::replace(&mut of.film, empty))?.unbind(),
            rest: of,
            grows: false,
        })
    }

    /// A picture that is not the last of its rendering.
    pub fn growing(py: Python, of: Rendered) -> PyResult<Self> {
        let grows = true;
        Ok(Self {
            grows,
            ..Self::new(py, of)?
        })
    }

    /// The picture with its standard errors.
    pub fn comparand(&self, py: Python, name: &str) -> PyResult<Comparand> {
        let film_of = |array: &Py<PyArray3<f32>>| film(&array.bind(py).readonly());
        let stderr = self.stderr.as_ref().map(film_of).transpose()?;
        Ok(Comparand::Memory {
            name: name.to_owned(),
            film: film_of(&self.rgb)?,
            origin: self.rest.record.job.crop.map(|[x, y, ..]| [x, y]),
            stderr: stderr.map(|film| (film, self.rest.freedom)),
        })
    }

    fn rendered(&self, py: Python) -> PyResult<Rendered> {
        Ok(Rendered {
            film: film(&self.rgb.bind(py).readonly())?,
            ..self.rest.clone()
        })
    }
}

#[pymethods]
impl Picture {
    /// The estimated error after the last sample.
    #[getter]
    fn error(&self) -> Option<ErrorAt> {
        self.rest.record.error.last().map(ErrorAt::from)
    }

    /// The same after 1, 2, 4 … samples.
    #[getter]
    fn errors(&self) -> Vec<ErrorAt> {
        self.rest.record.error.iter().map(ErrorAt::from).collect()
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.rest.record.seconds.render
    }

    #[getter]
    fn spp(&self) -> u32 {
        self.rest.record.job.spp
    }

    #[getter]
    fn ended(&self) -> Option<&str> {
        (!self.grows).then_some(&self.rest.record.job.ended)
    }

    #[getter]
    fn device(&self) -> &str {
        &self.rest.record.machine.device
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.rest.record.warnings.clone()
    }

    /// The contents of `vkpt SCENE --json FILE`.
    #[getter]
    fn record<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let text = serde_json::to_string(&self.rest.record);
        let text = text.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        py.import("json")?.call_method1("loads", (text,))
    }

    /// Writes the file that the command line would write, in the format of its name.
    #[pyo3(signature = (path, exposure = 0.0))]
    fn save(&self, py: Python, path: PathBuf, exposure: f64) -> PyResult<()> {
        let rendered = self.rendered(py)?;
        finite(py, exposure)?;
        let saved = py.detach(|| rendered.save(&path, exposure));
        saved.map_err(|failure| raise(py, failure))
    }

    /// The bytes of a PNG, brightened by `exposure` stops.
    #[pyo3(signature = (exposure = 0.0))]
    fn png<'py>(&self, py: Python<'py>, exposure: f64) -> PyResult<Bound<'py, PyBytes>> {
        let rendered = self.rendered(py)?;
        finite(py, exposure)?;
        let bytes = py.detach(|| rendered.encode(Format::Png, exposure));
        let bytes = bytes.map_err(|failure| raise(py, failure))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The PNG that a notebook shows.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.png(py, 0.0)
    }

    fn __repr__(&self) -> String {
        let Film { width, height, .. } = self.rest.film;
        let error = self.error().and_then(|error| error.rel_mse);
        let error = error.map_or(String::new(), |error| format!(", relMSE about {error:.1e}"));
        let (spp, ended) = (self.spp(), self.ended().unwrap_or("growing"));
        format!("<vkpt.Picture {width}x{height}, {spp} samples per pixel, {ended}{error}>")
    }
}

impl From<&report::ErrorAt> for ErrorAt {
    fn from(at: &report::ErrorAt) -> Self {
        Self {
            spp: at.spp,
            seconds: at.seconds,
            rel_mse: at.rel_mse,
            low: at.low,
            high: at.high,
        }
    }
}

#[pymethods]
impl ErrorAt {
    fn __repr__(&self) -> String {
        let number = |x: Option<f64>| x.map_or("None".to_owned(), |x| format!("{x:.3e}"));
        format!(
            "ErrorAt(spp={}, seconds={:.3}, rel_mse={}, low={}, high={})",
            self.spp,
            self.seconds,
            number(self.rel_mse),
            number(self.low),
            number(self.high)
        )
    }
}

/// Refuses an exposure that is not finite.
pub fn finite(py: Python, exposure: f64) -> PyResult<()> {
    match exposure.is_finite() {
        true => Ok(()),
        false => Err(raise(
            py,
            Failure::Usage("exposure must be a finite number of stops".to_owned()),
        )),
    }
}

/// Arrays of shape (height, width) for layers of one channel, else (height, width, channels), by the name before the dot.
fn layers<'py>(
    py: Python<'py>,
    channels: &[Channel],
    [width, height]: [u32; 2],
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let size = [height as usize, width as usize];
    for group in channels.chunk_by(|a, b| layer(a) == layer(b)) {
        let pixels = 0..size[0] * size[1];
        let values = pixels.flat_map(|i| group.iter().map(move |channel| channel.values[i]));
        let flat = PyArray1::from_vec(py, values.collect());
        let array = match group.len() {
            1 => flat.reshape(size)?.into_any(),
            n => flat.reshape([size[0], size[1], n])?.into_any(),
        };
        read_only(&array)?;
        dict.set_item(layer(&group[0]), array)?;
    }
    Ok(dict)
}

/// The name of a channel without its own letter.
fn layer(channel: &Channel) -> &str {
    channel
        .name
        .rsplit_once('.')
        .map_or(&channel.name, |(layer, _)| layer)
}
