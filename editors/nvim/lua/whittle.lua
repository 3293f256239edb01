-- Starts `whittle lsp` for scenes and gives its answers keys. Neovim 0.7 or newer; README.md says how it is installed.
local M = {}

M.keys = {
  ["K"] = vim.lsp.buf.hover,
  ["gd"] = vim.lsp.buf.definition,
  ["gr"] = vim.lsp.buf.references,
  ["gR"] = vim.lsp.buf.rename,
  ["gq"] = function()
    if vim.lsp.buf.format then vim.lsp.buf.format() else vim.lsp.buf.formatting_sync(nil, 5000) end
  end,
  ["]d"] = vim.diagnostic.goto_next,
  ["[d"] = vim.diagnostic.goto_prev,
}

local clients = {}  -- by root folder: texts of one folder share a server

local function root_of(path)
  local found = vim.fs and vim.fs.find(".git", { path = path, upward = true })[1]
  return found and vim.fn.fnamemodify(found, ":h") or vim.fn.fnamemodify(path, ":p:h")
end

local function attach(options, buffer)
  local path = vim.api.nvim_buf_get_name(buffer)
  if path == "" or vim.bo[buffer].buftype ~= "" then return end
  local root = root_of(path)
  if not clients[root] then
    clients[root] = vim.lsp.start_client({
      name = "whittle",
      cmd = options.cmd or { "whittle", "lsp" },
      root_dir = root,
      workspace_folders = { { uri = vim.uri_from_fname(root), name = root } },
      flags = { debounce_text_changes = 50 },
      on_exit = function() clients[root] = nil end,
      on_attach = function(_, attached)
        vim.bo[attached].omnifunc = "v:lua.vim.lsp.omnifunc"
        for key, does in pairs(options.keys or M.keys) do
          vim.keymap.set("n", key, does, { buffer = attached, silent = true })
        end
        if options.on_attach then options.on_attach(attached) end
      end,
    })
  end
  if clients[root] then vim.lsp.buf_attach_client(buffer, clients[root]) end
end

function M.setup(options)
  options = options or {}
  local group = vim.api.nvim_create_augroup("whittle", { clear = true })
  -- Other languages have files of the same ending; a text that Neovim knows as one of those stays it.
  vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, {
    group = group, pattern = { "*.pov", "*.POV", "*.inc", "*.INC" },
    callback = function(event)
      local known = vim.bo[event.buf].filetype
      local scene = event.match:lower():match("%.pov$") and known ~= "pov"
      if scene or known == "" or known == "conf" then
        vim.bo[event.buf].filetype = "pov"
      end
    end,
  })
  vim.api.nvim_create_autocmd("FileType", {
    group = group, pattern = "pov",
    callback = function(event)
      vim.bo[event.buf].commentstring = "// %s"
      vim.bo[event.buf].expandtab = true
      vim.bo[event.buf].shiftwidth = 2
      attach(options, event.buf)
    end,
  })
end

return M
