//! Volumes of a medium.

use freepath_estimators::medium::{Raw, RawType, Volume, VolumeRequest};
use freepath_formats::{NumberType, RawLayout, ReadError};
use std::path::Path;

/// The volume that `wanted` asks for, in the file `path`.
///
/// # Errors
/// Those of [`freepath_formats::read_volume`].
pub(crate) fn read_volume(path: &Path, wanted: &VolumeRequest) -> Result<Volume, ReadError> {
    let VolumeRequest { file: _, channel, raw, grid, voxels } = *wanted;
    let (raw, voxels) = (raw.map(layout), voxels.copied());
    let request = freepath_formats::VolumeRequest { channel, raw, grid, voxels };
    let freepath_formats::Volume { shape, values, bounds } = freepath_formats::read_volume(path, &request)?;
    Ok(Volume { shape, values, bounds })
}

fn layout(raw: &Raw) -> RawLayout {
    let values = match raw.values {
        RawType::U8 => NumberType::U8,
        RawType::U16 => NumberType::U16,
        RawType::F32 => NumberType::F32,
        RawType::F64 => NumberType::F64,
    };
    RawLayout { shape: raw.shape, values, big_endian: raw.big_endian, channels: raw.channels }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::quadrature;
    use freepath_estimators::medium::voxel_grid::{Filter, Grid, Rescale};
    use freepath_estimators::{Extinction, Majorants, Medium};
    use std::sync::Arc;

    fn shipped(name: &str) -> Volume {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/data");
        read_volume(&data.join(name), &VolumeRequest::of(name)).unwrap()
    }

    fn range(volume: &Volume) -> (f64, f64) {
        let mut sorted = volume.values.clone();
        sorted.sort_by(f64::total_cmp);
        (sorted[0], sorted[sorted.len() - 1])
    }

    #[test]
    fn the_shipped_volumes_are_read() {
        let epi = shipped("head_epi_24x96x128_u16.npy");
        assert_eq!((epi.shape, range(&epi)), ([128, 96, 24], (0.0, 1162.0)));
        let anat = shipped("head_anat_25x41x33_f32.npy");
        assert_eq!(anat.shape, [33, 41, 25]);
        assert!(range(&anat).0 < -600.0 && range(&anat).1 > 30_000.0);
    }

    #[test]
    fn a_measured_head_is_a_medium() {
        let bounds = [[0.0; 3], [256.0, 192.0, 52.8]];
        let build = |name, scale, offset| {
            let rescale = Rescale { scale, offset };
            Grid::new(Arc::new(shipped(name)), Filter::Trilinear, bounds, rescale)
        };
        let head = build("head_epi_24x96x128_u16.npy", 1e-4, 0.0).unwrap();
        let ray = head.ray([-10.0, 80.0, 5.0], [1.0, 0.1, 0.13]).unwrap();
        let integral = quadrature::integrate(&|t| ray.mu(t), 0.0, ray.length(), ray.breaks());
        assert!((ray.tau(ray.length()) - integral.value).abs() < 1e-12 * integral.value);
        assert_eq!(Majorants::tight(&ray, 64).shortfall(&ray), None);
        let refused = build("head_anat_25x41x33_f32.npy", 1e-4, 0.0).unwrap_err().to_string();
        assert!(refused.contains("[z][y][x] = ["), "{refused}");
        assert!(build("head_anat_25x41x33_f32.npy", 1e-4, 0.1).is_ok());
    }

    #[test]
    fn a_stated_layout_is_handed_on() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("raw.bin");
        std::fs::write(&file, [0, 1, 0, 2, 1, 0, 2, 0, 0, 7, 0, 8]).unwrap();
        let raw = Raw { shape: [3, 1, 1], values: RawType::U16, big_endian: true, channels: 2 };
        let wanted = VolumeRequest { channel: 1, raw: Some(&raw), ..VolumeRequest::of("") };
        let volume = read_volume(&file, &wanted).unwrap();
        assert_eq!((volume.shape, volume.values, volume.bounds), ([3, 1, 1], vec![2.0, 512.0, 8.0], None));
    }
}
