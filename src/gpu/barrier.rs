//! Memory barriers before and after each piece of work.

use ash::vk;

/// Makes earlier writes of host, kernels and copies visible to the following work.
///
/// # Safety
/// While recording.
pub(super) unsafe fn before(raw: &ash::Device, commands: vk::CommandBuffer) {
    use vk::{AccessFlags as A, PipelineStageFlags as S};
    let memory = vk::MemoryBarrier::default()
        .src_access_mask(A::HOST_WRITE | A::SHADER_WRITE | A::TRANSFER_WRITE)
        .dst_access_mask(
            A::UNIFORM_READ
                | A::SHADER_READ
                | A::SHADER_WRITE
                | A::TRANSFER_READ
                | A::TRANSFER_WRITE,
        );
    let from = S::HOST | S::COMPUTE_SHADER | S::TRANSFER;
    let to = S::COMPUTE_SHADER | S::TRANSFER;
    // SAFETY: of the caller.
    unsafe {
        raw.cmd_pipeline_barrier(commands, from, to, Default::default(), &[memory], &[], &[])
    };
}

/// Makes writes of kernels and copies visible to the host, once the fence has been waited for.
///
/// # Safety
/// While recording.
pub(super) unsafe fn after(raw: &ash::Device, commands: vk::CommandBuffer) {
    use vk::{AccessFlags as A, PipelineStageFlags as S};
    let memory = vk::MemoryBarrier::default()
        .src_access_mask(A::SHADER_WRITE | A::TRANSFER_WRITE)
        .dst_access_mask(A::HOST_READ | A::HOST_WRITE);
    let from = S::COMPUTE_SHADER | S::TRANSFER;
    // SAFETY: of the caller.
    unsafe {
        raw.cmd_pipeline_barrier(
            commands,
            from,
            S::HOST,
            Default::default(),
            &[memory],
            &[],
            &[],
        )
    };
}
