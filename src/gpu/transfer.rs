//! Transfers into and out of a buffer: directly if the host sees its memory, else by a staging buffer.

use ash::vk;

use super::buffer::Buffer;
use super::error::GpuError;
use crate::layout::BufferUse;

/// Bytes staged at a time.
const STAGE: u64 = 16 << 20;

impl Buffer {
    /// Writes `bytes` from the start on; there may be fewer than the buffer's size.
    ///
    /// # Errors
    /// [`GpuError::WrongLength`] if there are more.
    pub fn write(&self, bytes: &[u8]) -> Result<(), GpuError> {
        self.check_length(bytes.len())?;
        if let Some(first) = self.mapped {
            let _idle = self.device.queue()?;
            // SAFETY: the mapping has at least as many bytes as were checked for, and the lock keeps all
            // other users of it away.
            unsafe { std::ptr::copy_nonoverlapping(bytes.as_ptr(), first.as_ptr(), bytes.len()) };
            return Ok(());
        }
        let stage = self.stage()?;
        for (at, chunk) in chunks(bytes.len() as u64) {
            let range = at as usize..(at + chunk) as usize;
            stage.write(&bytes[range])?;
            self.copy(
                &stage,
                self,
                vk::BufferCopy {
                    src_offset: 0,
                    dst_offset: at,
                    size: chunk,
                },
            )?;
        }
        Ok(())
    }

    /// Fills `bytes` from the start of the buffer; there may be fewer than its size.
    ///
    /// # Errors
    /// [`GpuError::WrongLength`] if there are more.
    pub fn read_into(&self, bytes: &mut [u8]) -> Result<(), GpuError> {
        self.check_length(bytes.len())?;
        if let Some(first) = self.mapped {
            let _idle = self.device.queue()?;
            // SAFETY: as in `write`.
            unsafe {
                std::ptr::copy_nonoverlapping(first.as_ptr(), bytes.as_mut_ptr(), bytes.len())
            };
            return Ok(());
        }
        let stage = self.stage()?;
        for (at, chunk) in chunks(bytes.len() as u64) {
            let range = at as usize..(at + chunk) as usize;
            self.copy(
                self,
                &stage,
                vk::BufferCopy {
                    src_offset: at,
                    dst_offset: 0,
                    size: chunk,
                },
            )?;
            stage.read_into(&mut bytes[range])?;
        }
        Ok(())
    }

    /// All bytes of the buffer.
    pub fn read(&self) -> Result<Vec<u8>, GpuError> {
        let mut bytes = vec![0; self.bytes as usize];
        self.read_into(&mut bytes)?;
        Ok(bytes)
    }

    /// Sets all bytes to 0.
    pub fn clear(&self) -> Result<(), GpuError> {
        let mut queue = self.device.queue()?;
        // SAFETY: the buffer was made with TRANSFER_DST and lives until the work is done.
        let run = unsafe {
            queue.run(&self.device, |raw, commands| {
                raw.cmd_fill_buffer(commands, self.raw, 0, vk::WHOLE_SIZE, 0)
            })
        };
        run.map(|_| ())
    }

    fn check_length(&self, given: usize) -> Result<(), GpuError> {
        let given = given as u64;
        if given <= self.bytes {
            return Ok(());
        }
        Err(GpuError::WrongLength {
            name: self.name.clone(),
            bytes: self.bytes,
            given,
        })
    }

    /// A buffer that the host sees, as large as the next copy needs.
    fn stage(&self) -> Result<Self, GpuError> {
        use vk::MemoryPropertyFlags as M;
        let visible = M::HOST_VISIBLE | M::HOST_COHERENT;
        let flags = vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        let kinds = [visible | M::HOST_CACHED, visible];
        let name = format!("{} (staging)", self.name);
        Self::new(
            &self.device,
            name,
            BufferUse::Storage,
            self.bytes.min(STAGE),
            flags,
            &kinds,
            true,
        )
    }

    fn copy(&self, from: &Self, to: &Self, region: vk::BufferCopy) -> Result<(), GpuError> {
        let mut queue = self.device.queue()?;
        // SAFETY: both buffers were made for copies, contain the region (its size is not 0), and outlive the work.
        let run = unsafe {
            queue.run(&self.device, |raw, commands| {
                raw.cmd_copy_buffer(commands, from.raw, to.raw, &[region])
            })
        };
        run.map(|_| ())
    }
}

/// (start, length) of the pieces in which `bytes` bytes are staged.
fn chunks(bytes: u64) -> impl Iterator<Item = (u64, u64)> {
    (0..bytes)
        .step_by(STAGE as usize)
        .map(move |at| (at, STAGE.min(bytes - at)))
}
