-- What happens in the editor: a scene with a mistake is opened, mended, asked about and laid out, through the editor's own functions.
local function say(text) io.stdout:write(text .. "\n") end

local function check(what, right, found)
  if not right then error(what .. ": " .. vim.inspect(found), 2) end
  say(what .. " ok")
end

local function wait_for(what, condition)
  if not vim.wait(60000, condition, 20) then error(what .. " did not happen: " .. vim.inspect(vim.diagnostic.get(0)), 2) end
end

local function ask(method, line, character, more)
  local parameters = vim.tbl_extend("force", {
    textDocument = vim.lsp.util.make_text_document_params(0),
    position = { line = line, character = character },
  }, more or {})
  local answers = vim.lsp.buf_request_sync(0, "textDocument/" .. method, parameters, 60000)
  for _, answer in pairs(answers or {}) do return answer.result, answer.err or answer.error end
end

local function lines() return vim.api.nvim_buf_get_lines(0, 0, -1, false) end

local function run()
  vim.opt.runtimepath:prepend(vim.env.EDITORS .. "/nvim")
  vim.cmd("filetype on")
  require("whittle").setup({ cmd = { vim.env.WHITTLE, "lsp" } })
  vim.cmd("edit scene.pov")
  check("filetype", vim.bo.filetype == "pov", vim.bo.filetype)

  -- The mistake is told at its word, with the call of the macro.
  wait_for("a diagnostic", function() return #vim.diagnostic.get(0) > 0 end)
  local found = vim.diagnostic.get(0)
  check("diagnostic", #found == 1 and found[1].lnum == 7 and found[1].col == 27 and found[1].end_col == 31
    and found[1].severity == vim.diagnostic.severity.ERROR
    and found[1].message:find("'colr' is not declared; did you mean 'color'?", 1, true), found)
  local related = found[1].user_data.lsp.relatedInformation or {}
  check("where the macro was called", #related == 1 and related[1].location.range.start.line == 9, related)

  check("one server", #vim.lsp.get_active_clients() == 1, #vim.lsp.get_active_clients())

  -- Typing mends it.
  vim.api.nvim_buf_set_text(0, 7, 27, 7, 31, { "color" })
  wait_for("the end of the diagnostic", function() return #vim.diagnostic.get(0) == 0 end)
  say("mended ok")

  -- Completion as the editor's own key asks for it.
  vim.api.nvim_win_set_cursor(0, { 8, 27 })
  local start = vim.lsp.omnifunc(1, "")
  check("omnifunc", vim.bo.omnifunc == "v:lua.vim.lsp.omnifunc", { vim.bo.omnifunc, start })
  local offered = {}
  for _, item in ipairs(ask("completion", 7, 27).items) do offered[item.label] = true end
  check("completion", offered.color_map and offered.granite and offered.Size and not offered.phong and not offered.camera,
    vim.tbl_keys(offered))

  -- Hover: the editor's window holds the declaration and its value.
  vim.api.nvim_win_set_cursor(0, { 10, 6 })
  local windows = #vim.api.nvim_list_wins()
  vim.lsp.buf.hover()
  wait_for("the window of hover", function() return #vim.api.nvim_list_wins() > windows end)
  local shown = ""
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= "" then
      shown = table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), "\n")
      vim.api.nvim_win_close(window, true)
    end
  end
  check("hover", shown:find("#declare Wide = 3 / 2;", 1, true) and shown:find("1.5", 1, true), shown)

  -- Rename of a local name.
  vim.api.nvim_win_set_cursor(0, { 7, 10 })
  vim.lsp.buf.rename("Radius")
  wait_for("the new name", function() return lines()[8]:find("sphere { 0, Radius", 1, true) end)
  check("rename", lines()[7] == "  #local Radius = R * 2;", lines())

  -- Layout.
  if vim.lsp.buf.format then vim.lsp.buf.format() else vim.lsp.buf.formatting_sync(nil, 60000) end
  check("format", lines()[8] == "  sphere { 0, Radius pigment { color rgb 1 } }" and lines()[7] == "  #local Radius = R * 2;", lines())

  -- Through the include, last: it leaves the scene.
  vim.cmd("silent write")
  vim.api.nvim_win_set_cursor(0, { 10, 6 })
  vim.lsp.buf.definition()
  wait_for("the jump", function() return vim.fn.expand("%:t") == "parts.inc" end)
  check("definition", vim.deep_equal(vim.api.nvim_win_get_cursor(0), { 1, 9 }), vim.api.nvim_win_get_cursor(0))

  local id = vim.lsp.get_active_clients()[1].id
  vim.lsp.stop_client(id)
  wait_for("the server's end", function() return vim.lsp.client_is_stopped(id) end)
end

local right, why = xpcall(run, debug.traceback)
say(right and "all ok" or tostring(why))
vim.cmd(right and "qall!" or "cquit!")
