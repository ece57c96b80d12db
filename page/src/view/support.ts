// What the browser can draw with.

interface Support {
  isThere: boolean;
  /** Whether the processor draws: then every sample of a pixel costs time. */
  isSoftware: boolean;
}

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

let found: Support | null = null;

/** Asked once: the question needs a context of its own. */
export function support(): Support {
  found ??= probe();
  return found;
}

function probe(): Support {
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    if (context === null) return { isThere: false, isSoftware: true };
    const names = context.getExtension("WEBGL_debug_renderer_info");
    const parameter = names === null ? context.RENDERER : names.UNMASKED_RENDERER_WEBGL;
    const isSoftware = SOFTWARE.test(String(context.getParameter(parameter)));
    context.getExtension("WEBGL_lose_context")?.loseContext();
    return { isThere: true, isSoftware };
  } catch {
    return { isThere: false, isSoftware: true };
  }
}
