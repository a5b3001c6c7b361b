use crate::error::Refusal;

/// Bytes that contradict themselves.
pub(super) fn corrupt(what: &str) -> Refusal {
    Refusal::new(format!("its {what} makes no sense"), "a .vdb file as OpenVDB writes it")
}
