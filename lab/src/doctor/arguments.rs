//! Tables of arguments: random bits of fixed seeds, including values that are hard to round.

use vkpt::reference::sampler::pcg4d::pcg4d;

/// Rows of a table: enough to detect an operation that rounds wrongly once in 10⁵.
pub const ROWS: u32 = 1 << 20;

/// Zeros, the smallest and largest denormals, the smallest normal numbers, neighbours of 1, the largest, infinities, NaNs.
const SPECIAL: [u32; 20] = [
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x8000_0001,
    0x007f_ffff,
    0x807f_ffff,
    0x0080_0000,
    0x8080_0000,
    0x3f7f_ffff,
    0x3f80_0000,
    0xbf80_0000,
    0x3f80_0001,
    0x7f7f_ffff,
    0xff7f_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0xffc0_0000,
    0x7fc0_dead,
    0x4b80_0000,
];

/// Every pair of special numbers, then in turn: any bits; numbers within a factor of 2⁴⁰; a number and half a unit of
/// its last place, whose sum is a tie; denormals, or numbers whose product is one.
pub fn wide() -> Vec<[u32; 3]> {
    let n = SPECIAL.len();
    let pairs = (0..n * n).map(|k| [SPECIAL[k / n], SPECIAL[k % n], SPECIAL[(k / 3) % n]]);
    let rows = (0..ROWS - (n * n) as u32).map(|i| {
        let r = pcg4d([i, 0, 0, 0]);
        match i % 4 {
            0 => [r[0], r[1], r[2]],
            1 => [
                near(r[0], r[3], 127),
                near(r[1], r[3] >> 8, 127),
                near(r[2], r[3] >> 16, 127),
            ],
            2 => {
                let x = near(r[0], r[3], 127);
                [
                    x,
                    ((x & 0x7f80_0000) - (24 << 23)) | (r[1] & 0x8000_0000),
                    r[2],
                ]
            }
            _ if r[3] & 1 == 0 => [r[0] & 0x807f_ffff, near(r[1], r[3] >> 8, 127), r[2]],
            _ => [
                near(r[0], r[3], 63),
                near(r[1], r[3] >> 8, 63),
                r[2] & 0x807f_ffff,
            ],
        }
    });
    pairs.chain(rows).collect()
}

/// x, y and z = −xy rounded: xy + z is 0 with two roundings, and the error of the first with one.
pub fn cancelling() -> Vec<[u32; 3]> {
    let row = |i| {
        let r = pcg4d([i, 1, 0, 0]);
        let (x, y) = (near(r[0], r[3], 127), near(r[1], r[3] >> 8, 127));
        let product = f32::from_bits(x) * f32::from_bits(y);
        [x, y, (-product).to_bits()]
    };
    (0..ROWS).map(row).collect()
}

/// Sign and mantissa of `bits`; the exponent within 20 of `middle` (127: that of 1).
fn near(bits: u32, choice: u32, middle: u32) -> u32 {
    let exponent = middle - 20 + (choice & 0xff) % 41;
    (bits & 0x807f_ffff) | (exponent << 23)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_contain_the_hard_arguments() {
        let count = |condition: &dyn Fn([f32; 3]) -> bool| {
            let rows = wide().into_iter().map(|row| row.map(f32::from_bits));
            rows.filter(|row| condition(*row)).count()
        };
        let many = ROWS as usize / 20;
        assert!(count(&|[x, ..]| x.is_subnormal()) > many);
        assert!(
            count(&|[x, y, _]| x.is_normal() && y.is_normal() && (x * y).is_subnormal()) > many
        );
        // y is half of the distance of x from its neighbour.
        let tie = |[x, y, _]: [f32; 3]| {
            let [below, above] = [x.abs(), x.abs().next_up()].map(f64::from);
            2.0 * f64::from(y).abs() == above - below
        };
        assert!(count(&tie) > many);
        assert!(count(&|[x, ..]| x.is_nan()) > 20);
        let fused = cancelling().into_iter().map(|row| row.map(f32::from_bits));
        let differing = fused.filter(|[x, y, z]| x * y + z == 0.0 && x.mul_add(*y, *z) != 0.0);
        assert!(differing.count() > ROWS as usize / 2);
    }
}
