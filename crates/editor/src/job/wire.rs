//! The byte layout of a job: a sequence of blocks, each preceded by its length.
//!
//! A block is either a value as JSON or a column of plain numbers as in memory, both little-endian. There
//! is no checksum: the bytes pass between threads of one program, and the browser delivers them unchanged.
//! Lengths are checked against the remaining bytes before memory is reserved, so bytes that are not a job
//! are refused at no cost.
//!
//! Files and links hold the same blocks packed, so that compressing them gives few bytes: see [`super::packed`].

use super::packed;
use bytemuck::{AnyBitPattern, NoUninit};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cell::Cell;
use std::fmt;
use std::future::poll_fn;
use std::io::{self, Read, Write};
use std::pin::{Pin, pin};
use std::rc::Rc;
use std::task::{Context, Poll, Waker};

/// Why bytes could not be read as a job.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadBytes(String);

impl BadBytes {
    pub(crate) fn new(reason: impl fmt::Display) -> Self {
        Self(reason.to_string())
    }

    /// The reason alone.
    pub(crate) fn reason(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for BadBytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "these bytes are not a job: {}", self.0)
    }
}

impl std::error::Error for BadBytes {}

/// Messages between the page and its worker.
///
/// [`Wire::write_to`] and [`Wire::read_from`] copy each column of a mesh once, directly from and to its
/// memory. A mesh is therefore copied twice on its way between the page and the worker: from the sender's
/// memory to a buffer of [`Wire::byte_len`] bytes, which is transferred without a copy, and from there to
/// the receiver's memory.
pub trait Wire: Sized {
    /// Writes the value.
    ///
    /// # Errors
    /// Writing to `out` failed.
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()>;

    /// Reads a value that takes up exactly `len` bytes of `from`.
    ///
    /// # Errors
    /// The bytes are not such a value, or too few or too many. Meshes are not validated: only the lengths
    /// of their columns are checked.
    fn read_from(from: &mut dyn Read, len: usize) -> Result<Self, BadBytes> {
        at_once(Self::read(from, len, Part::unlimited()))
    }

    /// [`Wire::read_from`], with pauses where `part` is used up: what [`Reading`] goes on with.
    ///
    /// # Errors
    /// As [`Wire::read_from`].
    fn read(from: &mut dyn Read, len: usize, part: Part) -> impl Future<Output = Result<Self, BadBytes>>;

    /// The number of bytes that [`Wire::write_to`] writes. Costs O(columns) and the cost of the JSON.
    fn byte_len(&self) -> usize {
        let mut counter = Counter(0);
        // Writing to a counter can't fail.
        let _ = self.write_to(&mut counter);
        counter.0
    }

    /// The value as bytes.
    fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.byte_len());
        // Writing to a vector can't fail.
        let _ = self.write_to(&mut bytes);
        bytes
    }

    /// Reads what [`Wire::to_bytes`] wrote.
    ///
    /// # Errors
    /// As [`Wire::read_from`].
    fn from_bytes(mut bytes: &[u8]) -> Result<Self, BadBytes> {
        let len = bytes.len();
        Self::read_from(&mut bytes, len)
    }
}

/// A value that is read in parts, so that no frame of the page takes long: a million triangles take 60 MB.
pub struct Reading<T> {
    work: Pin<Box<dyn Future<Output = Result<T, BadBytes>>>>,
    part: Part,
}

impl<T> fmt::Debug for Reading<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Reading").finish_non_exhaustive()
    }
}

impl<T: Wire + 'static> Reading<T> {
    /// Begins to read a value that takes up exactly `len` bytes of `from`. Costs O(1).
    pub fn new(mut from: impl Read + 'static, len: usize) -> Self {
        let part = Part(Rc::default());
        let work = Box::pin({
            let part = part.clone();
            async move { T::read(&mut from, len, part).await }
        });
        Self { work, part }
    }

    /// Reads about this many bytes more; returns the value once it is complete. Don't go on after that.
    ///
    /// # Errors
    /// As [`Wire::read_from`].
    pub fn step(&mut self, bytes: usize) -> Option<Result<T, BadBytes>> {
        self.part.0.set(bytes);
        match self.work.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(read) => Some(read),
            Poll::Pending => None,
        }
    }
}

/// How many bytes may be read before the next pause.
#[derive(Clone, Debug)]
pub struct Part(Rc<Cell<usize>>);

impl Part {
    /// No pauses.
    pub(crate) fn unlimited() -> Self {
        Self(Rc::new(Cell::new(usize::MAX)))
    }

    /// Counts bytes, and pauses if these were the last.
    async fn count(&self, bytes: usize) {
        self.0.set(self.0.get().saturating_sub(bytes));
        poll_fn(|_| if self.0.get() == 0 { Poll::Pending } else { Poll::Ready(()) }).await;
    }
}

/// Does all the work of reading. Without a limit it never pauses.
pub(crate) fn at_once<T>(work: impl Future<Output = Result<T, BadBytes>>) -> Result<T, BadBytes> {
    match pin!(work).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(read) => read,
        Poll::Pending => Err(BadBytes::new("reading them paused")),
    }
}

/// Columns are read in pieces of this many bytes, with pauses between them.
const PIECE_BYTES: usize = 1 << 20;

/// Counts the bytes that are written to it.
struct Counter(usize);

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Writes blocks.
pub(crate) struct Writer<'a> {
    out: &'a mut dyn Write,
    is_packed: bool,
}

impl<'a> Writer<'a> {
    /// Begins with the mark that identifies the kind of value.
    pub fn start(out: &'a mut dyn Write, mark: [u8; 8]) -> io::Result<Self> {
        out.write_all(&mark)?;
        Ok(Self { out, is_packed: false })
    }

    /// [`Writer::start`] for packed blocks.
    pub fn start_packed(out: &'a mut dyn Write, mark: [u8; 8]) -> io::Result<Self> {
        Ok(Self { is_packed: true, ..Self::start(out, mark)? })
    }

    /// Whether blocks are packed.
    pub fn is_packed(&self) -> bool {
        self.is_packed
    }

    pub fn column<T: NoUninit>(&mut self, values: &[T]) -> io::Result<()> {
        if self.is_packed {
            self.out.write_all(&packed::varint(values.len() as u64))?;
            return packed::write_planes(self.out, bytemuck::cast_slice(values), size_of::<T>());
        }
        self.out.write_all(&(values.len() as u64).to_le_bytes())?;
        self.out.write_all(bytemuck::cast_slice(values))
    }

    /// A column of ids, packed by what they differ from those before them or from their places.
    pub fn links(&mut self, ids: &[u32]) -> io::Result<()> {
        if !self.is_packed {
            return self.column(ids);
        }
        self.out.write_all(&packed::varint(ids.len() as u64))?;
        self.column(&packed::pack_links(ids))
    }

    pub fn value(&mut self, value: &impl Serialize) -> io::Result<()> {
        self.column(&serde_json::to_vec(value)?)
    }
}

/// Reads blocks, never more than the given number of bytes.
pub(crate) struct Reader<'a> {
    from: &'a mut dyn Read,
    left: usize,
    is_packed: bool,
    part: Part,
}

impl<'a> Reader<'a> {
    /// Checks the mark at the start.
    pub fn start(from: &'a mut dyn Read, len: usize, mark: [u8; 8], part: Part) -> Result<Self, BadBytes> {
        let mut reader = Self { from, left: len, is_packed: false, part };
        let mut start = [0; 8];
        reader.fill(&mut start)?;
        if start == mark { Ok(reader) } else { Err(BadBytes::new("they begin with another mark")) }
    }

    /// [`Reader::start`] for packed blocks.
    pub fn start_packed(from: &'a mut dyn Read, len: usize, mark: [u8; 8]) -> Result<Self, BadBytes> {
        Ok(Self { is_packed: true, ..Self::start(from, len, mark, Part::unlimited())? })
    }

    /// Whether blocks are packed.
    pub fn is_packed(&self) -> bool {
        self.is_packed
    }

    fn fill(&mut self, bytes: &mut [u8]) -> Result<(), BadBytes> {
        self.left = self.left.checked_sub(bytes.len()).ok_or_else(|| BadBytes::new("they end too early"))?;
        self.from.read_exact(bytes).map_err(BadBytes::new)
    }

    /// The next column, with spare capacity: without it, the next edits would reallocate every column of
    /// the mesh.
    pub async fn column<T: AnyBitPattern + NoUninit>(&mut self) -> Result<Vec<T>, BadBytes> {
        let len = self.len()?;
        if len.checked_mul(size_of::<T>()).is_none_or(|bytes| bytes > self.left) {
            return Err(BadBytes::new("they end too early"));
        }
        let mut column = Vec::with_capacity(len + len / 16);
        column.resize(len, T::zeroed());
        let bytes = bytemuck::cast_slice_mut(&mut column);
        if self.is_packed && size_of::<T>() > 1 {
            let mut plane = vec![0; len];
            for at in 0..size_of::<T>() {
                self.fill(&mut plane)?;
                packed::put_plane(bytes, &plane, at, size_of::<T>());
            }
        } else {
            for piece in bytes.chunks_mut(PIECE_BYTES) {
                self.fill(piece)?;
                self.part.count(piece.len()).await;
            }
        }
        Ok(column)
    }

    /// The length of the next column.
    fn len(&mut self) -> Result<usize, BadBytes> {
        let len = if self.is_packed {
            packed::read_varint(|| {
                let mut byte = [0];
                self.fill(&mut byte).map(|()| byte[0])
            })?
        } else {
            let mut len = [0; 8];
            self.fill(&mut len)?;
            u64::from_le_bytes(len)
        };
        usize::try_from(len).map_err(BadBytes::new)
    }

    /// What [`Writer::links`] wrote.
    pub async fn links(&mut self) -> Result<Vec<u32>, BadBytes> {
        if !self.is_packed {
            return self.column().await;
        }
        let len = self.len()?;
        packed::unpack_links(&self.column::<u8>().await?, len)
    }

    pub async fn value<T: DeserializeOwned>(&mut self) -> Result<T, BadBytes> {
        serde_json::from_slice(&self.column::<u8>().await?).map_err(BadBytes::new)
    }

    pub fn end(self) -> Result<(), BadBytes> {
        if self.left == 0 { Ok(()) } else { Err(BadBytes::new("bytes follow after the end")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read<T>(
        bytes: &[u8],
        with: impl AsyncFnOnce(&mut Reader<'_>) -> Result<T, BadBytes>,
    ) -> Result<T, String> {
        let mut from = bytes;
        let work = async {
            let mut reader = Reader::start(&mut from, bytes.len(), *b"MWtest00", Part::unlimited())?;
            let value = with(&mut reader).await?;
            reader.end().map(|()| value)
        };
        at_once(work).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_longer_than_the_remaining_bytes_are_refused() {
        for len in [2, 1 << 20, u64::MAX / 4 + 2, u64::MAX] {
            let bytes = [*b"MWtest00", len.to_le_bytes(), [0; 8]].concat();
            let error = read(&bytes, async |from: &mut Reader<'_>| from.column::<[u32; 2]>().await)
                .expect_err("there are eight bytes");
            assert!(error.contains("too early"), "{error}");
        }
        let bytes = [*b"MWtest00", 1u64.to_le_bytes(), [7; 8]].concat();
        assert_eq!(
            read(&bytes, async |from: &mut Reader<'_>| from.column::<[u32; 2]>().await),
            Ok(vec![[0x0707_0707; 2]])
        );
        let error = read(&bytes, async |from: &mut Reader<'_>| from.column::<u32>().await)
            .expect_err("four bytes more");
        assert!(error.contains("after the end"), "{error}");
        assert!(
            read(&bytes, async |from: &mut Reader<'_>| from.value::<u32>().await).is_err(),
            "bytes of value 7 are not JSON"
        );
        assert!(read(b"MWother0", async |from: &mut Reader<'_>| from.column::<u32>().await).is_err());
    }
}
