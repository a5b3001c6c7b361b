/// The steps in which the numbers that follow a law come: by so much of its mass an interval may be off. Provided: none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grain {
    /// The step of the uniforms.
    pub uniform: f64,
    /// Half a step of the numbers, over the number.
    pub relative: f64,
    /// The most mass within half a step of any number, where steps do not grow with it.
    pub mass: f64,
}

impl Grain {
    /// That of floating-point numbers of so many bits, made of such uniforms.
    #[must_use]
    pub fn of_bits(bits: u32) -> Self {
        let step = libm::ldexp(1.0, -(bits as i32));
        Self { uniform: step, relative: step, mass: 0.0 }
    }

    /// That of ranks, each of which may be off by `mass`, made of uniforms of so many bits.
    #[must_use]
    pub fn of_ranks(bits: u32, mass: f64) -> Self {
        Self { uniform: libm::ldexp(1.0, -(bits as i32)), relative: 0.0, mass }
    }
}
