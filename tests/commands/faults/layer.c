/* A Vulkan layer that makes calls fail on purpose, as devices do that nobody has at hand.
 *
 * VKPT_FAULT=vkQueueSubmit:3:-4 makes the third vkQueueSubmit of the process return VK_ERROR_DEVICE_LOST; 3+ that one and
 * all after it. Several stand between commas. A device that never ends is vkWaitForFences:1:2 (VK_TIMEOUT): it returns at once.
 * VKPT_FAULT_COUNTS=FILE writes, when the process ends, how often each entry point was called. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>
#include <vulkan/vk_layer.h>

/* Each entry point that vkpt calls and that may fail: level, name, parameters, arguments. */
#define CREATE(NAME, INFO, OUT)                                                                                        \
    X(DEVICE, NAME, (VkDevice device, const INFO *info, const VkAllocationCallbacks *allocator, OUT *out),             \
      (device, info, allocator, out))
#define CALLS                                                                                                          \
    X(INSTANCE, vkEnumeratePhysicalDevices, (VkInstance instance, uint32_t *count, VkPhysicalDevice *out),             \
      (instance, count, out))                                                                                          \
    CREATE(vkCreateCommandPool, VkCommandPoolCreateInfo, VkCommandPool)                                                \
    X(DEVICE, vkAllocateCommandBuffers,                                                                                \
      (VkDevice device, const VkCommandBufferAllocateInfo *info, VkCommandBuffer *out), (device, info, out))           \
    CREATE(vkCreateQueryPool, VkQueryPoolCreateInfo, VkQueryPool)                                                      \
    CREATE(vkCreateFence, VkFenceCreateInfo, VkFence)                                                                  \
    CREATE(vkCreateBuffer, VkBufferCreateInfo, VkBuffer)                                                               \
    CREATE(vkAllocateMemory, VkMemoryAllocateInfo, VkDeviceMemory)                                                     \
    X(DEVICE, vkBindBufferMemory,                                                                                      \
      (VkDevice device, VkBuffer buffer, VkDeviceMemory memory, VkDeviceSize offset), (device, buffer, memory, offset)) \
    X(DEVICE, vkMapMemory,                                                                                             \
      (VkDevice device, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize size, VkMemoryMapFlags flags,         \
       void **out),                                                                                                    \
      (device, memory, offset, size, flags, out))                                                                      \
    CREATE(vkCreateDescriptorSetLayout, VkDescriptorSetLayoutCreateInfo, VkDescriptorSetLayout)                        \
    CREATE(vkCreatePipelineLayout, VkPipelineLayoutCreateInfo, VkPipelineLayout)                                       \
    CREATE(vkCreateDescriptorPool, VkDescriptorPoolCreateInfo, VkDescriptorPool)                                       \
    X(DEVICE, vkAllocateDescriptorSets,                                                                                \
      (VkDevice device, const VkDescriptorSetAllocateInfo *info, VkDescriptorSet *out), (device, info, out))           \
    CREATE(vkCreatePipelineCache, VkPipelineCacheCreateInfo, VkPipelineCache)                                          \
    X(DEVICE, vkGetPipelineCacheData, (VkDevice device, VkPipelineCache cache, size_t *size, void *out),               \
      (device, cache, size, out))                                                                                      \
    CREATE(vkCreateShaderModule, VkShaderModuleCreateInfo, VkShaderModule)                                             \
    X(DEVICE, vkCreateComputePipelines,                                                                                \
      (VkDevice device, VkPipelineCache cache, uint32_t count, const VkComputePipelineCreateInfo *infos,               \
       const VkAllocationCallbacks *allocator, VkPipeline *out),                                                       \
      (device, cache, count, infos, allocator, out))                                                                   \
    X(DEVICE, vkBeginCommandBuffer, (VkCommandBuffer commands, const VkCommandBufferBeginInfo *info), (commands, info)) \
    X(DEVICE, vkEndCommandBuffer, (VkCommandBuffer commands), (commands))                                              \
    X(DEVICE, vkQueueSubmit, (VkQueue queue, uint32_t count, const VkSubmitInfo *infos, VkFence fence),                \
      (queue, count, infos, fence))                                                                                    \
    X(DEVICE, vkWaitForFences,                                                                                         \
      (VkDevice device, uint32_t count, const VkFence *fences, VkBool32 all, uint64_t timeout),                        \
      (device, count, fences, all, timeout))                                                                           \
    X(DEVICE, vkResetFences, (VkDevice device, uint32_t count, const VkFence *fences), (device, count, fences))        \
    X(DEVICE, vkGetQueryPoolResults,                                                                                   \
      (VkDevice device, VkQueryPool pool, uint32_t first, uint32_t count, size_t size, void *out, VkDeviceSize stride, \
       VkQueryResultFlags flags),                                                                                      \
      (device, pool, first, count, size, out, stride, flags))

enum {
    CALL_vkCreateInstance,
    CALL_vkCreateDevice,
#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS) CALL_##NAME,
    CALLS
#undef X
    CALL_COUNT
};

static const char *const names[] = {
    "vkCreateInstance",
    "vkCreateDevice",
#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS) #NAME,
    CALLS
#undef X
};

static unsigned counts[CALL_COUNT];

/* What the calls go on to. All instances and devices of the process are of one driver, and share it; vkpt makes its calls one
 * after the other, on the device that it made last. */
static PFN_vkGetInstanceProcAddr next_instance;
static PFN_vkGetDeviceProcAddr next_device;
#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS) static PFN_##NAME next_##NAME;
CALLS
#undef X
static VkDevice latest;
static int lost;

/* The fault that the environment has for the n-th call, if any. */
static int is_asked_for(int call, unsigned n, VkResult *result) {
    const char *fault = getenv("VKPT_FAULT");
    size_t length = strlen(names[call]);
    for (; fault && *fault; fault += strcspn(fault, ","), fault += *fault == ',') {
        char *end;
        unsigned first;
        if (strncmp(fault, names[call], length) || fault[length] != ':')
            continue;
        first = (unsigned)strtoul(fault + length + 1, &end, 10);
        *result = (VkResult)atoi(end + strcspn(end, ":") + 1);
        if (n == first || (*end == '+' && n > first))
            return 1;
    }
    return 0;
}

/* Counts a call; whether it is to fail, and how. A device that was lost stays so for all who give it work or wait for it,
 * and has ended its work by the time that it says so. */
static int fails(int call, VkResult *result) {
    int meets_loss = call == CALL_vkQueueSubmit || call == CALL_vkWaitForFences || call == CALL_vkGetQueryPoolResults;
    int fails = is_asked_for(call, ++counts[call], result);
    if (!fails && lost && meets_loss) {
        *result = VK_ERROR_DEVICE_LOST;
        fails = 1;
    }
    if (fails && latest && *result == VK_ERROR_DEVICE_LOST) {
        lost = 1;
        ((PFN_vkDeviceWaitIdle)next_device(latest, "vkDeviceWaitIdle"))(latest);
    }
    return fails;
}

/* When the process ends: the layer is linked so that the loader cannot unload it before. */
__attribute__((destructor)) static void tell(void) {
    const char *path = getenv("VKPT_FAULT_COUNTS");
    FILE *out = path ? fopen(path, "w") : NULL;
    for (int call = 0; out && call < CALL_COUNT; call++)
        fprintf(out, "%s %u\n", names[call], counts[call]);
    if (out)
        fclose(out);
}

#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS)                                                                          \
    static VKAPI_ATTR VkResult VKAPI_CALL faulty_##NAME PARAMETERS {                                                   \
        VkResult result;                                                                                               \
        return fails(CALL_##NAME, &result) ? result : next_##NAME ARGUMENTS;                                           \
    }
CALLS
#undef X

/* The loader leaves a link of the chain in what an instance and a device are made from; each layer takes its own. */
static VKAPI_ATTR VkResult VKAPI_CALL faulty_vkCreateInstance(const VkInstanceCreateInfo *info,
                                                              const VkAllocationCallbacks *allocator, VkInstance *out) {
    VkLayerInstanceCreateInfo *chain = (VkLayerInstanceCreateInfo *)info->pNext;
    VkResult result;
    while (chain->sType != VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO || chain->function != VK_LAYER_LINK_INFO)
        chain = (VkLayerInstanceCreateInfo *)chain->pNext;
    next_instance = chain->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    chain->u.pLayerInfo = chain->u.pLayerInfo->pNext;
    if (fails(CALL_vkCreateInstance, &result))
        return result;
    result = ((PFN_vkCreateInstance)next_instance(NULL, "vkCreateInstance"))(info, allocator, out);
    if (result != VK_SUCCESS)
        return result;
#define INSTANCE(NAME) next_##NAME = (PFN_##NAME)next_instance(*out, #NAME);
#define DEVICE(NAME)
#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS) LEVEL(NAME)
    CALLS
#undef INSTANCE
#undef DEVICE
    return VK_SUCCESS;
}

static VKAPI_ATTR VkResult VKAPI_CALL faulty_vkCreateDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo *info,
                                                            const VkAllocationCallbacks *allocator, VkDevice *out) {
    VkLayerDeviceCreateInfo *chain = (VkLayerDeviceCreateInfo *)info->pNext;
    VkResult result;
    while (chain->sType != VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO || chain->function != VK_LAYER_LINK_INFO)
        chain = (VkLayerDeviceCreateInfo *)chain->pNext;
    next_device = chain->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    chain->u.pLayerInfo = chain->u.pLayerInfo->pNext;
    latest = VK_NULL_HANDLE;
    if (fails(CALL_vkCreateDevice, &result))
        return result;
    result = ((PFN_vkCreateDevice)next_instance(NULL, "vkCreateDevice"))(physical, info, allocator, out);
    if (result != VK_SUCCESS)
        return result;
    latest = *out;
    lost = 0;
#define INSTANCE(NAME)
#define DEVICE(NAME) next_##NAME = (PFN_##NAME)next_device(*out, #NAME);
    CALLS
#undef INSTANCE
#undef DEVICE
    return VK_SUCCESS;
}
#undef X

static PFN_vkVoidFunction own(const char *name) {
#define X(LEVEL, NAME, PARAMETERS, ARGUMENTS)                                                                          \
    if (!strcmp(name, #NAME))                                                                                          \
        return (PFN_vkVoidFunction)faulty_##NAME;
    X(, vkCreateInstance, , )
    X(, vkCreateDevice, , )
    CALLS
#undef X
    return NULL;
}

static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_device(VkDevice device, const char *name) {
    PFN_vkVoidFunction found = own(name);
    return found ? found : next_device(device, name);
}

static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_instance(VkInstance instance, const char *name) {
    PFN_vkVoidFunction found = own(name);
    if (!strcmp(name, "vkGetDeviceProcAddr"))
        return (PFN_vkVoidFunction)of_device;
    return found || !instance ? found : next_instance(instance, name);
}

VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface *negotiated) {
    negotiated->loaderLayerInterfaceVersion = 2;
    negotiated->pfnGetInstanceProcAddr = of_instance;
    negotiated->pfnGetDeviceProcAddr = of_device;
    negotiated->pfnGetPhysicalDeviceProcAddr = NULL;
    return VK_SUCCESS;
}
