//! How much a browser downloads.

use std::{fs, io::Write, path::Path};

use anyhow::{Context, Result, bail};

use crate::project::files_below;

/// What may be downloaded until the first interactive design, compressed, bytes. The goal is 1,500,000: readers of files and of
/// drawings, planets and phases are above it until the page fetches its rarer parts on first use.
const BUDGET_BYTES: usize = 1_700_000;

/// Prints the size of every file, plain and compressed as a host may send it; returns the compressed sum, bytes.
pub fn print(dist: &Path) -> Result<usize> {
    let mut sum = Size::default();
    println!("\n{:>12} {:>12}  file", "bytes", "brotli");
    for file in files_below(dist)? {
        let size = Size::of(&fs::read(&file)?)?;
        sum.add(size);
        println!(
            "{:>12} {:>12}  {}",
            size.plain_bytes,
            size.compressed_bytes,
            file.strip_prefix(dist)?.display()
        );
    }
    println!(
        "{:>12} {:>12}  of {BUDGET_BYTES}, the budget",
        sum.plain_bytes, sum.compressed_bytes
    );
    Ok(sum.compressed_bytes)
}

/// Fails if the budget is exceeded.
pub fn check(compressed_bytes: usize) -> Result<()> {
    if compressed_bytes > BUDGET_BYTES {
        bail!(
            "the app is {compressed_bytes} bytes compressed, above the {BUDGET_BYTES} of the budget"
        );
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
        // Quality 9: within a few per cent of the best, in a tenth of its time. Window 2^22 bytes.
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
    use super::Size;

    #[test]
    fn ten_thousand_equal_bytes_compress_below_one_hundred() {
        let size = Size::of(&[7; 10_000]).unwrap();
        assert_eq!(size.plain_bytes, 10_000);
        assert!(size.compressed_bytes > 0 && size.compressed_bytes < 100);
    }
}
