//! Scenes: where the truth of a case lives, along one ray if it has several. A kind takes the scene that it needs by its type.

use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{Medium, ParameterError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::any::Any;
use std::sync::Arc;

/// The truth of a case.
pub trait Scene: Any + Send + Sync {
    /// The extinctions along the ray. Provided: none, of a scene without a medium.
    fn views(&self) -> Vec<View<'_>> {
        Vec::new()
    }
}

impl dyn Scene {
    /// The scene, if it is of this type.
    #[must_use]
    pub fn get<T: Scene>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }
}

/// A scene that a case states under its name, with a check of its parameters.
pub trait StatedScene: Scene + Clone {
    /// Refuses parameters that make no scene.
    ///
    /// # Errors
    /// Naming the parameter.
    fn check(&self) -> Result<(), ParameterError>;
}

/// Names to types: an enum with one variant per file of the folder `scene`.
macro_rules! scenes {
    ($($file:ident::$Type:ident,)*) => {
        $(mod $file; pub use $file::$Type;)*

        /// A scene without a medium that a case can name.
        #[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
        #[allow(non_camel_case_types, reason = "a variant is named as in a case: serde would write density1d")]
        pub enum AnyScene {
            $(
                #[doc = concat!("See [`", stringify!($Type), "`].")]
                // The schema refers to the type, whose own words are the ones to show.
                #[schemars(description = "")]
                $file($Type),
            )*
        }

        impl AnyScene {
            /// The names that a case may use.
            pub const NAMES: &[&str] = &[$(stringify!($file),)*];

            /// The name of this one.
            #[must_use]
            pub(crate) fn name(&self) -> &'static str {
                match self { $(Self::$file(_) => stringify!($file),)* }
            }

            /// Refuses parameters that make no scene.
            ///
            /// # Errors
            /// Naming the parameter.
            pub(crate) fn check(&self) -> Result<(), ParameterError> {
                match self { $(Self::$file(scene) => scene.check(),)* }
            }

            /// The scene.
            #[must_use]
            pub(crate) fn build(&self) -> Arc<dyn Scene> {
                match self { $(Self::$file(scene) => Arc::new(scene.clone()),)* }
            }
        }
    };
}

scenes! {
    chain::Chain,
    density_1d::Density1d,
    directions::Directions,
    discrete::Discrete,
    grid::Grid,
    integrand::Integrand,
    linear_system::LinearSystem,
    number::Number,
}

/// One extinction of a scene.
pub struct View<'a> {
    /// The words before its numbers where there are several, such as `channel 0: `.
    pub label: String,
    /// The extinction.
    pub medium: &'a dyn Medium,
}

/// One extinction, under the majorants of the case.
pub struct MediumScene(pub Arc<dyn Medium>);

impl Scene for MediumScene {
    fn views(&self) -> Vec<View<'_>> {
        vec![View { label: String::new(), medium: &*self.0 }]
    }
}

/// Homogeneous channels.
pub(crate) struct ChannelScene(pub ChromaticMedium);

impl Scene for ChannelScene {
    fn views(&self) -> Vec<View<'_>> {
        let media = self.0.media().iter().enumerate();
        media.map(|(i, channel)| View { label: format!("channel {i}: "), medium: &channel.extinction }).collect()
    }
}
