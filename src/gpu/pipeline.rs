//! A kernel made ready for a device.

use std::sync::Arc;

use ash::vk;

use super::device::Device;
use super::error::GpuError;
use super::pipeline_cache::PipelineCache;
use super::shared_device::SharedDevice;
use crate::kernel::Spirv;
use crate::layout::BufferUse;

/// A compute pipeline: binding i of set 0 is the i-th buffer.
pub struct Pipeline {
    pub(super) device: Arc<SharedDevice>,
    pub(super) uses: Vec<BufferUse>,
    pub(super) push_bytes: u32,
    set_layout: vk::DescriptorSetLayout,
    pub(super) layout: vk::PipelineLayout,
    pool: vk::DescriptorPool,
    pub(super) set: vk::DescriptorSet,
    pub(super) raw: vk::Pipeline,
}

impl Device {
    /// Makes a kernel ready. Drivers may defer compilation until the first dispatch.
    ///
    /// `push_bytes`: the size of its push constants, a multiple of 4.
    ///
    /// # Errors
    /// [`GpuError::Mismatch`] if it exceeds the device's limits.
    pub fn pipeline(
        &self,
        kernel: &Spirv,
        uses: &[BufferUse],
        push_bytes: u32,
    ) -> Result<Pipeline, GpuError> {
        self.check_kernel(kernel, uses, push_bytes)?;
        let mut pipeline = Pipeline {
            device: self.0.clone(),
            uses: uses.to_vec(),
            push_bytes,
            set_layout: vk::DescriptorSetLayout::null(),
            layout: vk::PipelineLayout::null(),
            pool: vk::DescriptorPool::null(),
            set: vk::DescriptorSet::null(),
            raw: vk::Pipeline::null(),
        };
        // On an error, dropping destroys what was made.
        pipeline.make_layout()?;
        pipeline.make_set()?;
        pipeline.make_pipeline(kernel)?;
        Ok(pipeline)
    }

    fn check_kernel(
        &self,
        kernel: &Spirv,
        uses: &[BufferUse],
        push_bytes: u32,
    ) -> Result<(), GpuError> {
        let l = &self.0.limits;
        let uniforms = uses.iter().filter(|u| **u == BufferUse::Uniform).count();
        let size = kernel.workgroup_size;
        let invocations: u32 = size.iter().product();
        for (what, asked, limit) in [
            ("uniform buffers", uniforms as u32, l.uniform_buffers),
            (
                "storage buffers",
                (uses.len() - uniforms) as u32,
                l.storage_buffers,
            ),
            ("bytes of push constants", push_bytes, l.push_constants),
            (
                "invocations in a workgroup",
                invocations,
                l.group_invocations,
            ),
            ("invocations along x", size[0], l.group_size[0]),
            ("invocations along y", size[1], l.group_size[1]),
            ("invocations along z", size[2], l.group_size[2]),
        ] {
            if asked > limit {
                return Err(GpuError::Mismatch(format!(
                    "{asked} {what}, but the device allows {limit}"
                )));
            }
        }
        Ok(())
    }
}

pub(super) fn descriptor(usage: BufferUse) -> vk::DescriptorType {
    match usage {
        BufferUse::Uniform => vk::DescriptorType::UNIFORM_BUFFER,
        BufferUse::Storage => vk::DescriptorType::STORAGE_BUFFER,
    }
}

impl Pipeline {
    fn make_layout(&mut self) -> Result<(), GpuError> {
        let raw = &self.device.raw;
        let binding = |(i, usage): (u32, &BufferUse)| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(i)
                .descriptor_type(descriptor(*usage))
                .descriptor_count(1)
                .stage_flags(vk::ShaderStageFlags::COMPUTE)
        };
        let bindings: Vec<_> = (0..).zip(&self.uses).map(binding).collect();
        let set = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
        let push = [vk::PushConstantRange {
            stage_flags: vk::ShaderStageFlags::COMPUTE,
            offset: 0,
            size: self.push_bytes,
        }];
        // SAFETY: both infos are complete, their parts live until the calls return.
        unsafe {
            let layout = raw.create_descriptor_set_layout(&set, None);
            self.set_layout = layout.map_err(GpuError::of("vkCreateDescriptorSetLayout"))?;
            let sets = [self.set_layout];
            let mut info = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
            if self.push_bytes > 0 {
                info = info.push_constant_ranges(&push);
            }
            self.layout = raw
                .create_pipeline_layout(&info, None)
                .map_err(GpuError::of("vkCreatePipelineLayout"))?;
        }
        Ok(())
    }

    fn make_set(&mut self) -> Result<(), GpuError> {
        let raw = &self.device.raw;
        // One of each more than needed: an empty pool is not allowed.
        let size = |usage| {
            let n = self.uses.iter().filter(|u| **u == usage).count() as u32;
            vk::DescriptorPoolSize {
                ty: descriptor(usage),
                descriptor_count: n + 1,
            }
        };
        let sizes = [size(BufferUse::Uniform), size(BufferUse::Storage)];
        let pool = vk::DescriptorPoolCreateInfo::default()
            .max_sets(1)
            .pool_sizes(&sizes);
        // SAFETY: the infos are complete, their parts live until the calls return.
        unsafe {
            self.pool = raw
                .create_descriptor_pool(&pool, None)
                .map_err(GpuError::of("vkCreateDescriptorPool"))?;
            let layouts = [self.set_layout];
            let info = vk::DescriptorSetAllocateInfo::default()
                .descriptor_pool(self.pool)
                .set_layouts(&layouts);
            self.set = raw
                .allocate_descriptor_sets(&info)
                .map_err(GpuError::of("vkAllocateDescriptorSets"))?[0];
        }
        Ok(())
    }

    fn make_pipeline(&mut self, kernel: &Spirv) -> Result<(), GpuError> {
        let raw = &self.device.raw;
        let cache = PipelineCache::open(&self.device, kernel);
        let flags = match self.device.statistics {
            Some(_) => vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR,
            None => vk::PipelineCreateFlags::empty(),
        };
        let code = vk::ShaderModuleCreateInfo::default().code(&kernel.words);
        // SAFETY: the words come from `kernel::compile`, whose output is valid SPIR-V with the entry point `main`;
        // the module may go once the pipeline is made.
        unsafe {
            let module = raw
                .create_shader_module(&code, None)
                .map_err(GpuError::of("vkCreateShaderModule"))?;
            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::COMPUTE)
                .module(module)
                .name(c"main");
            let info = vk::ComputePipelineCreateInfo::default()
                .flags(flags)
                .stage(stage)
                .layout(self.layout);
            let made = raw.create_compute_pipelines(cache.raw(), &[info], None);
            raw.destroy_shader_module(module, None);
            self.raw =
                made.map_err(|(_, result)| GpuError::of("vkCreateComputePipelines")(result))?[0];
        }
        cache.keep();
        Ok(())
    }
}

impl Drop for Pipeline {
    fn drop(&mut self) {
        if self.device.is_abandoned() {
            return;
        }
        let raw = &self.device.raw;
        // SAFETY: no work is in flight (each piece is waited for); null handles are ignored.
        unsafe {
            raw.destroy_pipeline(self.raw, None);
            raw.destroy_descriptor_pool(self.pool, None);
            raw.destroy_pipeline_layout(self.layout, None);
            raw.destroy_descriptor_set_layout(self.set_layout, None);
        }
    }
}
