/// The place where a fault is laid, which says how the subject must be driven: the folder of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layer {
    /// The majorants, under the audit: by the block method.
    Majorants,
    /// The look-ups and the ray, above the audit: by the block method.
    LookUps,
    /// One walk at a time, its uniforms and its look-ups: by the scalar method.
    Walk,
    /// The uniforms of one walk at a time: by the scalar method.
    Uniforms,
    /// The uniforms of one draw at a time where there is no ray: by the scalar method.
    Numbers,
    /// The tables that are made of weights: by the block method.
    Tables,
    /// The division of an integrand by the density of its draws: by the block method.
    Densities,
    /// The draws of a block.
    Draws,
    /// The weights of a block of chromatic draws.
    Channels,
}
