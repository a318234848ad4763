//! Three-component vectors and colours, with every sum in a written-out order.
//!
//! Twin: `shaders/math/vec.glsl`. GLSL's own `dot`, `length` and `normalize` may be evaluated in any
//! order by a driver, so the kernels do not use them.

use std::ops::{Add, AddAssign, Div, Index, Mul, MulAssign, Neg, Sub};

use glam::DVec3;

use super::real::Real;
pub use crate::layout::Vec3;

/// The vector (x, y, z).
pub fn vec3<F>(x: F, y: F, z: F) -> Vec3<F> {
    Vec3 { x, y, z }
}

impl<F: Real> Vec3<F> {
    /// All three components `x`.
    pub fn splat(x: F) -> Self {
        vec3(x, x, x)
    }
    /// (0, 0, 0)
    pub fn zero() -> Self {
        Self::splat(F::zero())
    }
    /// (1, 1, 1)
    pub fn one() -> Self {
        Self::splat(F::one())
    }
    /// Each component rounded to the nearest `F`.
    pub fn new(v: DVec3) -> Self {
        Self::rounded(v, F::new)
    }
    /// The exact values.
    pub fn f64(self) -> DVec3 {
        self.widened(F::f64)
    }
    /// All components are 0, of either sign.
    pub fn is_zero(self) -> bool {
        self == Self::zero()
    }
}

/// `b < a ? b : a`, spelt out because SPIR-V leaves FMin's result undefined for NaN and for zeros of two signs.
pub fn min2<F: Real>(a: F, b: F) -> F {
    if b < a { b } else { a }
}

/// `a < b ? b : a`, see [`min2`].
pub fn max2<F: Real>(a: F, b: F) -> F {
    if a < b { b } else { a }
}

/// a·b = (a.x b.x + a.y b.y) + a.z b.z
pub fn dot3<F: Real>(a: Vec3<F>, b: Vec3<F>) -> F {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// a × b
pub fn cross3<F: Real>(a: Vec3<F>, b: Vec3<F>) -> Vec3<F> {
    vec3(
        a.y * b.z - a.z * b.y,
        a.z * b.x - a.x * b.z,
        a.x * b.y - a.y * b.x,
    )
}

/// |v| = √(v·v)
pub fn length3<F: Real>(v: Vec3<F>) -> F {
    dot3(v, v).sqrt()
}

/// v · (1/|v|); in `f32` for |v| between 1e-18 and 1e19, outside of which the squares leave the scalar's range.
pub fn normalize3<F: Real>(v: Vec3<F>) -> Vec3<F> {
    v * (F::one() / length3(v))
}

/// The largest of the three components.
pub fn max_component<F: Real>(v: Vec3<F>) -> F {
    max2(max2(v.x, v.y), v.z)
}

/// (x + y + z)/3, the mean over RGB, of grey exactly: x + ((y − x) + (z − x))/3.
pub fn mean3<F: Real>(v: Vec3<F>) -> F {
    v.x + ((v.y - v.x) + (v.z - v.x)) * F::new(1.0 / 3.0)
}

macro_rules! elementwise {
    ($trait:ident, $f:ident, $op:tt) => {
        impl<F: Real> $trait for Vec3<F> {
            type Output = Self;
            fn $f(self, o: Self) -> Self {
                vec3(self.x $op o.x, self.y $op o.y, self.z $op o.z)
            }
        }
    };
}
elementwise!(Add, add, +);
elementwise!(Sub, sub, -);
elementwise!(Mul, mul, *);
elementwise!(Div, div, /);

impl<F: Real> Mul<F> for Vec3<F> {
    type Output = Self;
    fn mul(self, k: F) -> Self {
        vec3(self.x * k, self.y * k, self.z * k)
    }
}
impl<F: Real> Div<F> for Vec3<F> {
    type Output = Self;
    fn div(self, k: F) -> Self {
        vec3(self.x / k, self.y / k, self.z / k)
    }
}
impl<F: Real> Neg for Vec3<F> {
    type Output = Self;
    fn neg(self) -> Self {
        vec3(-self.x, -self.y, -self.z)
    }
}
impl<F: Real> AddAssign for Vec3<F> {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<F: Real> MulAssign for Vec3<F> {
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}
impl<F: Real> Index<usize> for Vec3<F> {
    type Output = F;
    fn index(&self, axis: usize) -> &F {
        match axis {
            0 => &self.x,
            1 => &self.y,
            _ => &self.z,
        }
    }
}
