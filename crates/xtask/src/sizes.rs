//! Download sizes of the app.

use std::{fs, io::Write, path::Path};

use anyhow::{Context, Result, bail};

use crate::project::files_below;

/// Files that a browser loads together.
struct Part {
    /// Unique name.
    name: &'static str,
    /// Largest compressed size, bytes.
    budget_bytes: usize,
    /// Prefixes of the file names; the first part has all files that no other part names.
    files: &'static [&'static str],
}

/// The page and the solver are loaded until the first solved design.
const PARTS: [Part; 3] = [
    Part {
        name: "the page",
        budget_bytes: 790_000,
        files: &[],
    },
    Part {
        name: "the solver",
        budget_bytes: 545_000,
        files: &["worker"],
    },
    // readers and writers of files, aerodynamics, six degrees of freedom, flights of an outline, the benchmark
    Part {
        name: "the toolbox, on first use",
        budget_bytes: 780_000,
        files: &["tools"],
    },
];

/// Compressed sizes of the parts, bytes.
pub type Sizes = [usize; PARTS.len()];

/// Prints the size of every file, plain and compressed as a host may send it, by part; returns the sums of the parts.
pub fn print(dist: &Path) -> Result<Sizes> {
    let files = files_below(dist)?;
    let mut sums = [0; PARTS.len()];
    for (part, sum) in PARTS.iter().zip(&mut sums) {
        println!("\n{:>12} {:>12}  {}", "bytes", "brotli", part.name);
        let mut total = Size::default();
        for file in files.iter().filter(|file| part_of(file).name == part.name) {
            let size = Size::of(&fs::read(file)?)?;
            total.add(size);
            println!(
                "{:>12} {:>12}  {}",
                size.plain_bytes,
                size.compressed_bytes,
                file.strip_prefix(dist)?.display()
            );
        }
        println!(
            "{:>12} {:>12}  of {}, the budget",
            total.plain_bytes, total.compressed_bytes, part.budget_bytes
        );
        *sum = total.compressed_bytes;
    }
    let [page, solver, _] = sums;
    println!("{:>25}  until the first solved design", page + solver);
    Ok(sums)
}

fn part_of(file: &Path) -> &'static Part {
    let parts = const { &PARTS };
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let has = |part: &&Part| part.files.iter().any(|start| name.starts_with(start));
    parts.iter().find(has).unwrap_or(&parts[0])
}

/// Fails if a budget is exceeded.
pub fn check(sizes: Sizes) -> Result<()> {
    for (part, bytes) in PARTS.iter().zip(sizes) {
        if bytes > part.budget_bytes {
            bail!(
                "{}: {bytes} bytes compressed, above the {} of the budget",
                part.name,
                part.budget_bytes
            );
        }
    }
    Ok(())
}

#[derive(Clone, Copy, Default)]
struct Size {
    plain_bytes: usize,
    compressed_bytes: usize,
}

impl Size {
    fn of(content: &[u8]) -> Result<Self> {
        // quality 9: within a few percent of the best, in a tenth of its time; window 2^22 bytes
        let mut compressed = brotli::CompressorWriter::new(Vec::new(), 1 << 16, 9, 22);
        compressed.write_all(content).context("cannot compress")?;
        let compressed_bytes = compressed.into_inner().len();
        Ok(Self {
            plain_bytes: content.len(),
            compressed_bytes,
        })
    }

    fn add(&mut self, other: Self) {
        self.plain_bytes += other.plain_bytes;
        self.compressed_bytes += other.compressed_bytes;
    }
}

#[cfg(test)]
mod tests {
    use super::{PARTS, Size, check, part_of};
    use std::path::Path;

    #[test]
    fn each_file_has_its_part_and_each_part_its_budget() {
        let part = |name: &str| part_of(Path::new(name)).name;
        assert_eq!(part("dist/code-1/tools_bg.wasm"), PARTS[2].name);
        assert_eq!(part("dist/code-1/worker_bg.wasm"), PARTS[1].name);
        assert_eq!(part("dist/tools/app.js"), PARTS[0].name);
        let budgets = PARTS.map(|part| part.budget_bytes);
        assert!(check(budgets).is_ok());
        for i in 0..PARTS.len() {
            let mut above = budgets;
            above[i] += 1;
            assert!(check(above).is_err(), "{}", PARTS[i].name);
        }
    }

    #[test]
    fn ten_thousand_equal_bytes_compress_below_one_hundred() {
        let size = Size::of(&[7; 10_000]).unwrap();
        assert_eq!(size.plain_bytes, 10_000);
        assert!(size.compressed_bytes > 0 && size.compressed_bytes < 100);
    }
}
