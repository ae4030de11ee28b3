#include "row_editor.h"

#include "row_facts.h"

#include <QWidget>

namespace lds::ui {

QString RowEditor::brokenRules(const settings::Write& write) const
{
    if (!m_session)
        return {};
    settings::Values state = RowFacts::wantedValues(*m_session);
    for (const auto& value : write)
        state.insert(value.item, value.value);
    const auto refusals = settings::check(m_session->model(), state);
    return RowFacts(m_row, *m_session).problemSentences(refusals, state).join(u' ');
}

RowEditor* rowEditor(QWidget* widget) { return dynamic_cast<RowEditor*>(widget); }

} // namespace lds::ui
