//! Tools that tests of other languages need, and the tests that a machine without them leaves out.
//!
//! The tests that need tools take this file in as it stands.

use std::process::{Command, Stdio};

/// A program of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// A Python with NumPy.
    Python,
    /// A C compiler.
    C,
    /// A C++ compiler.
    Cpp,
}

/// The tests that need tools: package, name, and what it needs.
pub const NEEDING: &[(&str, &str, &[Tool])] = &[
    ("freepath-cli", "the_python_example_is_judged_right", &[Tool::Python]),
    ("freepath-cli", "the_cpp_example_is_judged_right", &[Tool::Cpp]),
    ("freepath-cli", "the_c_example_is_judged_right", &[Tool::C]),
    ("freepath-cli", "python_reads_every_table", &[Tool::Python]),
    ("freepath-cli", "cpp_reads_every_table", &[Tool::Cpp]),
    ("freepath-cli", "c_reads_every_table", &[Tool::C]),
    ("freepath-cli", "python_draws_in_every_scene", &[Tool::Python]),
    ("freepath-cli", "cpp_draws_in_every_scene", &[Tool::Cpp]),
    ("freepath-cli", "c_draws_in_every_scene", &[Tool::C]),
    ("freepath-cli", "python_looks_up_every_medium", &[Tool::Python]),
    ("freepath-cli", "cpp_looks_up_every_medium", &[Tool::Cpp]),
    ("freepath-cli", "c_looks_up_every_medium", &[Tool::C]),
    ("freepath-cli", "a_mistake_in_python_is_told", &[Tool::Python]),
    ("freepath-cli", "the_readme_leads_to_verdicts", &[Tool::Python, Tool::Cpp]),
    ("freepath-capi", "the_commands_of_the_readme_build_and_run_the_example", &[Tool::Cpp]),
    ("freepath-capi", "the_example_in_cpp_judges_with_the_static_and_the_shared_library", &[Tool::Cpp]),
];

impl Tool {
    /// True if it runs.
    #[must_use]
    pub fn is_there(self) -> bool {
        let (program, args): (_, &[&str]) = match self {
            Self::Python => (python(), &["-c", "import numpy"]),
            Self::C => ("cc".into(), &["--version"]),
            Self::Cpp => ("c++".into(), &["--version"]),
        };
        let status = Command::new(program).args(args).stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.is_ok_and(|status| status.success())
    }

    fn how_to_get(self) -> &'static str {
        match self {
            Self::Python => {
                "there is no python3 with NumPy (install python3-numpy, or name an interpreter by FREEPATH_PYTHON)"
            }
            Self::C => "there is no `cc` (install a C compiler, such as gcc)",
            Self::Cpp => "there is no `c++` (install a C++17 compiler, such as g++)",
        }
    }
}

/// The interpreter.
#[must_use]
pub fn python() -> String {
    std::env::var("FREEPATH_PYTHON").unwrap_or_else(|_| "python3".into())
}

/// True if the test of this name can run; if not, it says why.
///
/// # Panics
/// If the list does not have the test.
#[must_use]
pub fn can_run(package: &str, test: &str) -> bool {
    let needs = NEEDING.iter().find(|need| (need.0, need.1) == (package, test));
    let (.., tools) = needs.unwrap_or_else(|| panic!("NEEDING does not have {test} of {package}"));
    let missing: Vec<Tool> = tools.iter().copied().filter(|tool| !tool.is_there()).collect();
    for tool in &missing {
        eprintln!("LEFT OUT: {test} was not tested; {}", tool.how_to_get());
    }
    missing.is_empty()
}

/// A line for each tool that is missing, with the tests that are left out for want of it.
#[must_use]
pub fn left_out() -> Vec<String> {
    let missing = [Tool::Python, Tool::C, Tool::Cpp].into_iter().filter(|tool| !tool.is_there());
    let line = |tool: Tool| {
        let tests: Vec<&str> =
            NEEDING.iter().filter(|(.., needs)| needs.contains(&tool)).map(|(_, name, _)| *name).collect();
        format!("LEFT OUT: {}: {}", tool.how_to_get(), tests.join(", "))
    };
    missing.map(line).collect()
}
