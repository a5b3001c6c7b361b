//! Scenes: where the truth of a case lives, along one ray if it has several. A kind takes the scene that it needs by its type.

use freepath_estimators::Medium;
use freepath_estimators::medium::ChromaticMedium;
use std::any::Any;
use std::sync::Arc;

/// The truth of a case.
pub trait Scene: Any + Send + Sync {
    /// The extinctions along the ray; none of a scene without a medium.
    fn views(&self) -> Vec<View<'_>>;
}

impl dyn Scene {
    /// The scene, if it is of this type.
    #[must_use]
    pub fn get<T: Scene>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }
}

/// One extinction of a scene.
pub struct View<'a> {
    /// What comes before its numbers where there are several, such as `channel 0: `.
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
pub struct ChannelScene(pub ChromaticMedium);

impl Scene for ChannelScene {
    fn views(&self) -> Vec<View<'_>> {
        let media = self.0.media().iter().enumerate();
        media.map(|(i, (channel, _))| View { label: format!("channel {i}: "), medium: channel }).collect()
    }
}
