//! Films as NumPy arrays and back.

use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use vkpt::film::Film;

/// The pixels as a read-only array of shape (height, width, 3); they are moved, not copied.
pub fn array<'py>(py: Python<'py>, film: Film) -> PyResult<Bound<'py, PyArray3<f32>>> {
    let Film { width, height, rgb } = film;
    let shape = [height as usize, width as usize, 3];
    let array = PyArray1::from_vec(py, rgb.into_flattened()).reshape(shape)?;
    read_only(array.as_any())?;
    Ok(array)
}

/// Makes the array read-only.
pub fn read_only(array: &Bound<PyAny>) -> PyResult<()> {
    let flags = pyo3::types::PyDict::new(array.py());
    flags.set_item("write", false)?;
    array.call_method("setflags", (), Some(&flags))?;
    Ok(())
}

/// A copy of the pixels of an array of shape (height, width, 3).
pub fn film(array: &PyReadonlyArray3<f32>) -> PyResult<Film> {
    let shape = array.shape();
    let &[height, width, 3] = shape else {
        let message = format!("a picture has the shape (height, width, 3), not {shape:?}");
        return Err(PyValueError::new_err(message));
    };
    let values = array.to_vec()?;
    Ok(Film {
        width: width as u32,
        height: height as u32,
        rgb: values.as_chunks().0.to_vec(),
    })
}
