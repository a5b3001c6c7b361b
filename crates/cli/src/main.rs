//! The command `freepath`.

fn main() -> std::process::ExitCode {
    freepath_cli::Command::named("freepath").run()
}
