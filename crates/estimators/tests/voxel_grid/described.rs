//! The grid as a case describes it.

use crate::rays::{at, close, grid, rough};
use freepath_estimators::medium::voxel_grid::Filter;
use freepath_estimators::medium::{AnyMedium, Built, Nodes, NodesRequest, Ray, Resolver, Volume, VolumeRequest};
use freepath_estimators::{Extinction, Medium, ParameterError};
use std::sync::Arc;

struct Folder(Option<Ray>);

impl Resolver for Folder {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        assert_eq!(*wanted, VolumeRequest::of("rough.npy"));
        Ok(rough())
    }
    fn nodes(&self, _: &NodesRequest) -> Result<Nodes, ParameterError> {
        panic!("a volume has no nodes")
    }
    fn ray(&self) -> Option<Ray> {
        self.0
    }
}

fn built(medium: &AnyMedium, folder: &Folder) -> Arc<dyn Medium> {
    match medium.build(folder).unwrap() {
        Built::Grey(ray) => ray,
        Built::Chromatic(_) => panic!("a volume is grey"),
    }
}

const JSON: &str = r#"{ "voxel_grid": { "file": "rough.npy", "filter": "trilinear", "scale": 2.0,
    "bounds": [[-1, 0.5, 2], [1, 3.5, 4.5]], "origin": [0.1, 0.2, 1.3], "direction": [0, 1, 1.5] } }"#;

#[test]
fn a_case_describes_it() {
    let described: AnyMedium = serde_json::from_str(JSON).unwrap();
    assert_eq!(described.name(), "voxel_grid");
    let again: AnyMedium = serde_json::from_str(&serde_json::to_string(&described).unwrap()).unwrap();
    assert_eq!(again, described);
    let ray = built(&described, &Folder(None));
    let half = grid(rough(), Filter::Trilinear).ray([0.1, 0.2, 1.3], [0.0, 1.0, 1.5]).unwrap();
    close(ray.tau(ray.length()), 2.0 * half.tau(half.length()), 1e-12, "scale");
    let other = built(&described, &Folder(Some(Ray { origin: at([0.5; 3]), direction: [0.0, 0.0, -3.0] })));
    close(other.length(), 1.25, 1e-15, "the ray of the resolver, from the middle");
}

#[test]
fn a_case_with_rays_needs_no_other() {
    let (ray, both) = (Ray { origin: at([0.5; 3]), direction: [0.0, 0.0, -3.0] }, Folder(None));
    let [origin, direction] = [r#", "origin": [0.1, 0.2, 1.3]"#, r#", "direction": [0, 1, 1.5]"#];
    for (left, missing) in
        [(vec![origin, direction], "origin"), (vec![origin], "origin"), (vec![direction], "direction")]
    {
        let text = left.iter().fold(JSON.to_string(), |text, key| text.replace(key, ""));
        let without: AnyMedium = serde_json::from_str(&text).unwrap();
        let again: AnyMedium = serde_json::from_str(&serde_json::to_string(&without).unwrap()).unwrap();
        assert_eq!(again, without);
        close(built(&without, &Folder(Some(ray))).length(), 1.25, 1e-15, "the ray of the case, from the middle");
        let why = without.build(&both).map(|_| String::new()).unwrap_or_else(|why| why.to_string());
        let due = format!("{missing} must be three numbers, unless the case has `rays`, not missing");
        assert_eq!(why, due);
    }
}

#[test]
fn a_wrong_case_is_refused() {
    let changes = [
        (r#""scale""#, r#""scales""#),
        ("trilinear", "tricubic"),
        ("[0, 1, 1.5]", "[0, 0, 0]"),
        ("[1, 3.5, 4.5]", "[1, 0.5, 4.5]"),
        ("[0.1, 0.2, 1.3]", "[0.1, 0.2]"),
        (r#""file": "rough.npy","#, ""),
    ];
    for (from, to) in changes {
        assert!(JSON.contains(from), "{from}");
        assert!(serde_json::from_str::<AnyMedium>(&JSON.replace(from, to)).is_err(), "{to}");
    }
}

/// A folder with one `.vdb` file, which may know its bounds.
struct Sparse(Option<[[f64; 3]; 2]>);

impl Resolver for Sparse {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        assert_eq!((wanted.grid, wanted.voxels), (Some("density"), Some(&[[-1, 0, 2], [3, 4, 5]])));
        Ok(Arc::new(Volume { bounds: self.0, ..(*rough()).clone() }))
    }
    fn nodes(&self, _: &NodesRequest) -> Result<Nodes, ParameterError> {
        panic!("a volume has no nodes")
    }
    fn ray(&self) -> Option<Ray> {
        None
    }
}

#[test]
fn a_file_may_know_its_bounds_and_a_case_may_overrule_them() {
    const OWN: &str = r#""bounds": [[-1, 0.5, 2], [1, 3.5, 4.5]],"#;
    let sparse =
        JSON.replace("rough.npy\"", "r.vdb\", \"grid\": \"density\", \"voxels\": [[-1, 0, 2], [3, 4, 5]]");
    let build = |text: &str, known| {
        let built = serde_json::from_str::<AnyMedium>(text).unwrap().build(&Sparse(known));
        built.map(|built| if let Built::Grey(ray) = built { ray.length() } else { f64::NAN })
    };
    let stated = build(&sparse, None).unwrap();
    let without = sparse.replace(OWN, "");
    assert_eq!(build(&without, Some([[-1.0, 0.5, 2.0], [1.0, 3.5, 4.5]])), Ok(stated));
    let twice = Some([[-2.0, -2.5, -0.5], [2.0, 3.5, 4.5]]);
    assert!(build(&without, twice).unwrap() > stated && build(&sparse, twice) == Ok(stated));
    let refused = build(&without, None).unwrap_err().to_string();
    assert!(
        refused.contains("bounds must be two corners of the box") && refused.contains("not missing"),
        "{refused}"
    );
}

#[test]
fn only_a_vdb_file_has_grids_and_a_part() {
    for more in [r#""grid": "density""#, r#""voxels": [[0, 0, 0], [1, 1, 1]]"#] {
        let text = JSON.replace(r#""filter""#, &format!(r#"{more}, "filter""#));
        let refused = serde_json::from_str::<AnyMedium>(&text).unwrap_err().to_string();
        assert!(refused.contains("except for a .vdb file"), "{refused}");
        assert!(serde_json::from_str::<AnyMedium>(&text.replace(".npy", ".VDB")).is_ok());
    }
}
