//! The Vulkan loader, an instance, and the messages of the validation layer.

use std::ffi::{CStr, c_void};
use std::sync::{Mutex, PoisonError};

use ash::{ext, vk};

use super::error::GpuError;

const VALIDATION_LAYER: &CStr = c"VK_LAYER_KHRONOS_validation";

/// An instance of Vulkan 1.1 or later.
pub(super) struct Instance {
    pub raw: ash::Instance,
    validation: Option<Validation>,
    /// Last: the loader's library must outlive everything else.
    _entry: ash::Entry,
}

struct Validation {
    utils: ext::debug_utils::Instance,
    messenger: vk::DebugUtilsMessengerEXT,
    /// Boxed, because the messenger has its address.
    messages: Box<Mutex<Vec<String>>>,
}

impl Instance {
    /// # Errors
    /// [`GpuError::NoVulkan`] without a loader or without any driver, [`GpuError::NoValidationLayer`].
    pub fn new(validation: bool) -> Result<Self, GpuError> {
        // SAFETY: loading a library runs its initialisers; the Vulkan loader's are harmless.
        let entry = unsafe { ash::Entry::load() }.map_err(|e| GpuError::NoVulkan(e.to_string()))?;
        if validation && !has_layer(&entry) {
            return Err(GpuError::NoValidationLayer);
        }
        let raw = create(&entry, validation)?;
        let mut instance = Self {
            raw,
            validation: None,
            _entry: entry,
        };
        if validation {
            instance.validation = Some(Validation::listen(&instance._entry, &instance.raw)?);
        }
        Ok(instance)
    }

    /// Warnings and errors of the validation layer so far.
    pub fn messages(&self) -> Vec<String> {
        let messages = self.validation.as_ref().map(|v| &v.messages);
        messages.map_or_else(Vec::new, |m| {
            m.lock().unwrap_or_else(PoisonError::into_inner).clone()
        })
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        // SAFETY: the messenger and then the instance are destroyed once, after everything that was made from them:
        // devices hold the instance.
        unsafe {
            if let Some(v) = &self.validation {
                v.utils.destroy_debug_utils_messenger(v.messenger, None);
            }
            self.raw.destroy_instance(None);
        }
    }
}

fn has_layer(entry: &ash::Entry) -> bool {
    // SAFETY: no preconditions.
    let layers = unsafe { entry.enumerate_instance_layer_properties() }.unwrap_or_default();
    layers
        .iter()
        .any(|l| l.layer_name_as_c_str() == Ok(VALIDATION_LAYER))
}

fn create(entry: &ash::Entry, validation: bool) -> Result<ash::Instance, GpuError> {
    let app = vk::ApplicationInfo::default()
        .application_name(c"vkpt")
        .api_version(vk::API_VERSION_1_1);
    let layers = [VALIDATION_LAYER.as_ptr()];
    let extensions = [
        ext::debug_utils::NAME.as_ptr(),
        ext::validation_features::NAME.as_ptr(),
    ];
    let enabled = [vk::ValidationFeatureEnableEXT::SYNCHRONIZATION_VALIDATION];
    let mut features = vk::ValidationFeaturesEXT::default().enabled_validation_features(&enabled);
    let mut info = vk::InstanceCreateInfo::default().application_info(&app);
    if validation {
        info = info
            .enabled_layer_names(&layers)
            .enabled_extension_names(&extensions)
            .push_next(&mut features);
    }
    // SAFETY: everything `info` points to lives until the call returns.
    unsafe { entry.create_instance(&info, None) }.map_err(|result| match result {
        vk::Result::ERROR_INCOMPATIBLE_DRIVER => {
            GpuError::NoVulkan("the loader found no driver".into())
        }
        result => GpuError::of("vkCreateInstance")(result),
    })
}

impl Validation {
    fn listen(entry: &ash::Entry, instance: &ash::Instance) -> Result<Self, GpuError> {
        use vk::{
            DebugUtilsMessageSeverityFlagsEXT as Severity, DebugUtilsMessageTypeFlagsEXT as Type,
        };
        let utils = ext::debug_utils::Instance::new(entry, instance);
        let messages = Box::<Mutex<Vec<String>>>::default();
        let info = vk::DebugUtilsMessengerCreateInfoEXT::default()
            .message_severity(Severity::WARNING | Severity::ERROR)
            .message_type(Type::VALIDATION)
            .pfn_user_callback(Some(collect))
            .user_data(std::ptr::from_ref(&*messages).cast_mut().cast());
        // SAFETY: the callback takes user_data for what it is, and the box lives until the messenger is destroyed.
        let messenger = unsafe { utils.create_debug_utils_messenger(&info, None) }
            .map_err(GpuError::of("vkCreateDebugUtilsMessengerEXT"))?;
        Ok(Self {
            utils,
            messenger,
            messages,
        })
    }
}

/// The layer's callback: stores the message.
unsafe extern "system" fn collect(
    _severity: vk::DebugUtilsMessageSeverityFlagsEXT,
    _kind: vk::DebugUtilsMessageTypeFlagsEXT,
    data: *const vk::DebugUtilsMessengerCallbackDataEXT<'_>,
    messages: *mut c_void,
) -> vk::Bool32 {
    // SAFETY: the layer passes valid data, with a terminated string if any, and the user_data that `listen`
    // set, which is only ever used as a shared reference.
    unsafe {
        let messages = &*messages.cast::<Mutex<Vec<String>>>();
        if let Some(text) = data
            .as_ref()
            .filter(|d| !d.p_message.is_null())
            .map(|d| CStr::from_ptr(d.p_message))
        {
            messages
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .push(text.to_string_lossy().into_owned());
        }
    }
    vk::FALSE
}
