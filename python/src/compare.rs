//! `vkpt compare A B`, into memory.

use std::path::PathBuf;

use numpy::{PyArray3, PyReadonlyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vkpt::image;
use vkpt::metrics::Trimmed;
use vkpt_lab::cli::exit::Failure;
use vkpt_lab::compare::command::{Comparand, compared};
use vkpt_lab::compare::report::Tested;

use crate::arrays::{array, film};
use crate::caller::call;
use crate::failure::raise;
use crate::picture::{Picture, finite};

/// A picture that a program passes.
#[derive(FromPyObject)]
pub enum Pictured<'py> {
    #[pyo3(transparent)]
    Picture(Bound<'py, Picture>),
    #[pyo3(transparent)]
    Array(PyReadonlyArray3<'py, f32>),
    #[pyo3(transparent)]
    File(PathBuf),
}

impl Pictured<'_> {
    fn comparand(&self, name: &str) -> PyResult<Comparand> {
        Ok(match self {
            Self::Picture(picture) => picture.get().comparand(picture.py(), name)?,
            Self::Array(array) => Comparand::Memory {
                name: name.to_owned(),
                film: film(array)?,
                origin: None,
                stderr: None,
            },
            Self::File(path) => Comparand::File(path.clone()),
        })
    }
}

/// Compares picture `a` with the reference `b`; returns a dict.
#[pyfunction]
pub fn compare<'py>(
    py: Python<'py>,
    a: Pictured,
    b: Pictured,
    exposure: f64,
) -> PyResult<Bound<'py, PyDict>> {
    finite(py, exposure)?;
    let [a, b] = [a.comparand("a")?, b.comparand("b")?];
    let comparison = call(py, None, move || compared(a, b, exposure))?;
    let comparison = comparison.map_err(|failure| raise(py, failure))?;
    let dict = PyDict::new(py);
    for tested in &comparison.tested {
        fill(&dict, tested)?;
    }
    Ok(dict)
}

fn fill(dict: &Bound<PyDict>, tested: &Tested) -> PyResult<()> {
    let Tested {
        errors,
        flip,
        z_test,
        ..
    } = tested;
    let metric = |name: &str, of: Trimmed| {
        dict.set_item(name, of.all)?;
        dict.set_item(format!("{name}_without_worst"), of.without_worst)
    };
    metric("mse", errors.mse)?;
    metric("rmse", errors.rmse)?;
    metric("rel_mse", errors.rel_mse)?;
    metric("smape", errors.smape)?;
    metric("flip", *flip)?;
    dict.set_item("mean_a", errors.test_mean)?;
    dict.set_item("mean_b", errors.reference_mean)?;
    let test = z_test.as_ref();
    dict.set_item("z_test_passes", test.ok().map(|test| test.passes()))?;
    dict.set_item("z_test_rejected", test.ok().map(|test| test.rejected()))?;
    dict.set_item("z_test_lacks", test.err())
}

/// Reads a picture, or a layer of an EXR, as an array of shape (height, width, 3).
#[pyfunction]
pub fn read<'py>(
    py: Python<'py>,
    path: PathBuf,
    layer: Option<&str>,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    let read = match layer {
        Some(layer) => image::read_layer(&path, layer),
        None => image::read(&path),
    };
    let wrong = |error: image::ReadError| Failure::Pictures(vec![error.to_string()]);
    let picture = read.map_err(|error| raise(py, wrong(error)))?;
    array(py, picture.film)
}
