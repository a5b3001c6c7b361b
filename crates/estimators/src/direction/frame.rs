use super::Vector;

/// An orthonormal, right-handed basis about a normal.
///
/// ```text
/// s = sign(z),   a = -1/(s + z),   t = (1 + s x^2 a, s x y a, -s x),   b = (x y a, s + y^2 a, -y)
/// ```
///
/// |s + z| is at least 1 for any unit normal, so that nothing cancels near -z, where Frisvad's form (2012), which divides by 1 + z, loses
/// every digit.
///
/// Source: Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin 2017, Building an Orthonormal Basis, Revisited, Journal
/// of Computer Graphics Techniques 6(1), listing 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The first axis.
    pub tangent: Vector,
    /// The second axis.
    pub bitangent: Vector,
    /// The third axis.
    pub normal: Vector,
}

impl Frame {
    /// The basis about a unit vector.
    #[must_use]
    pub fn about(normal: Vector) -> Self {
        let [x, y, z] = normal;
        let sign = 1f64.copysign(z);
        let a = -1.0 / (sign + z);
        let b = x * y * a;
        Self {
            tangent: [1.0 + sign * x * x * a, sign * b, -sign * x],
            bitangent: [b, sign + y * y * a, -y],
            normal,
        }
    }

    /// The vector of these coordinates in the basis.
    #[inline(always)]
    #[must_use]
    pub fn to_world(&self, [x, y, z]: Vector) -> Vector {
        let along = |i: usize| x * self.tangent[i] + y * self.bitangent[i] + z * self.normal[i];
        [along(0), along(1), along(2)]
    }
}

/// The inner product.
#[inline(always)]
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Half the squared distance of two vectors: 1 - cos of the angle between unit vectors, without the digits that 1 - a.b loses at
/// small angles.
#[inline(always)]
pub(super) fn depth(a: Vector, b: Vector) -> f64 {
    let apart = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    0.5 * dot(apart, apart)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unit vectors all over the sphere, and the poles with neighbours as near as 1e-12.
    fn normals() -> impl Iterator<Item = Vector> {
        let spiral = (0..1000).map(|i| {
            let (z, phi) = (1.0 - (2.0 * f64::from(i) + 1.0) / 1000.0, 2.4 * f64::from(i));
            let r = (1.0 - z * z).sqrt();
            [r * libm::cos(phi), r * libm::sin(phi), z]
        });
        let tilts = (1..=12).map(|i| libm::exp10(-f64::from(i))).chain([0.0]);
        let near = tilts.flat_map(|tilt| {
            let z = (1.0 - tilt * tilt).sqrt();
            [[tilt, 0.0, z], [tilt, 0.0, -z], [0.0, -tilt, -z], [-0.6 * tilt, 0.8 * tilt, -z]]
        });
        spiral.chain(near)
    }

    #[test]
    fn a_frame_is_orthonormal_and_right_handed_about_every_normal() {
        for n in normals() {
            let Frame { tangent: t, bitangent: b, normal: n } = Frame::about(n);
            let off = [dot(t, t) - 1.0, dot(b, b) - 1.0, dot(t, b), dot(t, n), dot(b, n)];
            assert!(off.iter().all(|x| x.abs() <= 4e-15), "{n:?}: {off:?}");
            let across = [t[1] * b[2] - t[2] * b[1], t[2] * b[0] - t[0] * b[2], t[0] * b[1] - t[1] * b[0]];
            assert!((dot(across, n) - 1.0).abs() <= 4e-15, "{n:?} is left-handed");
        }
    }

    #[test]
    fn a_depth_keeps_its_digits_at_small_angles() {
        for angle in [1e-9, 1e-5, 0.3, 1.5, std::f64::consts::PI] {
            let w = [libm::sin(angle), 0.0, libm::cos(angle)];
            let half = libm::sin(0.5 * angle);
            assert!((depth(w, [0.0, 0.0, 1.0]) / (2.0 * half * half) - 1.0).abs() < 1e-14, "{angle}");
        }
    }
}
